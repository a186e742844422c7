#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "lab/study.h"
#include "math/nearest_name.h"
#include "weft/error.h"
#include "weft/integrators.h"

namespace weft {

namespace {

constexpr std::string_view compare_word = "compare";

// The words of the command line, told apart: experiments by their names, the rest are scenes.
struct Words {
    bool compare = false;
    std::vector<const lab::Experiment*> experiments;
    std::vector<std::string> scenes;
};

std::vector<std::string_view> experiment_names() {
    std::vector<std::string_view> names;
    for (const lab::Experiment& experiment : lab::experiment_catalogue()) {
        names.push_back(experiment.name);
    }
    return names;
}

Words sort_words(const std::vector<std::string>& words) {
    Words sorted;
    for (const std::string& word : words) {
        if (const lab::Experiment* experiment = lab::find_experiment(word)) {
            const auto& known = sorted.experiments;
            if (std::ranges::find(known, experiment) == known.end()) {
                sorted.experiments.push_back(experiment);
            }
        } else if (word == compare_word && sorted.scenes.empty()) {
            sorted.compare = true;
        } else {
            sorted.scenes.push_back(word);
        }
    }
    return sorted;
}

// One scene, or with `compare` two; without any, the sheet that the paper compares methods on.
void check_scenes(Words& words) {
    const std::size_t wanted = words.compare ? 2 : 1;
    if (words.scenes.empty() && !words.compare) words.scenes.emplace_back("sheet");
    if (words.scenes.size() == wanted) return;
    throw Error(ErrorKind::usage, {.key = "lab"},
                words.compare ? fmt::format("compare takes two scenes, not {}", words.scenes.size())
                              : fmt::format("takes one scene, not {}: \"{}\" and \"{}\"",
                                            words.scenes.size(), words.scenes[0], words.scenes[1]),
                "Run \"weft list experiments\" for the experiments, \"weft list scenes\" for the "
                "scenes.");
}

// Experiments and scenes share the command line: a misspelt experiment would be a scene not found.
SceneDescription load_named(const LabCommandOptions& options, const std::string& name) {
    SceneOptions scene;
    scene.scene = name;
    scene.set = options.set;
    try {
        return load_scene(scene);
    } catch (const Error& error) {
        const std::vector<std::string_view> names = experiment_names();
        const std::string hint = did_you_mean(name, names);
        if (hint.empty() || name.find('.') != std::string::npos) throw;
        throw Error(error.kind(), error.place(), error.message() + hint, error.detail());
    }
}

std::string quoted(const std::string& word) {
    const bool plain = word.find_first_of(" \t\"'\\$`*?[]{}()<>|&;!#~") == std::string::npos;
    return plain && !word.empty() ? word : "'" + word + "'";
}

// What makes the same study again, but for the experiments.
std::string arguments_of(const LabCommandOptions& options, const Words& words) {
    std::string text;
    for (const std::string& scene : words.scenes) text += quoted(scene) + " ";
    for (const std::string& set : options.set) text += "--set " + quoted(set) + " ";
    if (!options.methods.empty()) {
        text += fmt::format("--methods {} ", fmt::join(options.methods, ","));
    }
    if (options.quick) text += "--quick ";
    text.pop_back();
    return text;
}

std::filesystem::path directory_of(const LabCommandOptions& options,
                                   const std::vector<SceneDescription>& scenes) {
    if (!options.directory.empty()) return options.directory;
    std::string name = scenes.front().stem;
    if (scenes.size() == 2) name += "-" + scenes.back().stem;
    return std::filesystem::path("weft-lab") / (options.quick ? name + "-quick" : name);
}

// One line, updated in place at a terminal; elsewhere a line whenever another twentieth is done.
class LabProgressLine {
public:
    explicit LabProgressLine(bool enabled)
        : enabled_(enabled),
          terminal_(isatty(STDERR_FILENO) != 0),
          start_(std::chrono::steady_clock::now()) {}
    ~LabProgressLine() { end(); }
    LabProgressLine(const LabProgressLine&) = delete;
    LabProgressLine& operator=(const LabProgressLine&) = delete;

    void show(const lab::LabProgress& progress) {
        if (!progress.trial.empty()) measured_ += progress.fraction - last_;
        last_ = progress.fraction;
        if (!enabled_ || (!terminal_ && progress.fraction < next_)) return;
        next_ = progress.fraction + 0.05;
        std::string line =
            fmt::format("{:3.0f} %  {}", 100.0 * progress.fraction, progress.experiment);
        if (progress.of > 0) line += fmt::format("  {}/{}", progress.done, progress.of);
        line += time_left();
        if (!terminal_) {
            fmt::print(stderr, "{}\n", line);
            return;
        }
        fmt::print(stderr, "\r{}  {}\x1b[K", line, progress.trial.substr(0, 40));
        std::fflush(stderr);
        open_ = true;
    }
    void end() {
        if (open_) fmt::print(stderr, "\r\x1b[K");
        open_ = false;
    }

private:
    // From what was measured, not read from an earlier study: that takes no time.
    [[nodiscard]] std::string time_left() const {
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        if (measured_ < 0.01 || seconds < 2.0) return {};
        return fmt::format("  {} left", duration_text((1.0 - last_) * seconds / measured_));
    }

    bool enabled_, terminal_, open_ = false;
    std::chrono::steady_clock::time_point start_;
    double measured_ = 0.0, last_ = 0.0, next_ = 0.0;
};

void print_file(const std::filesystem::path& path) {
    std::ifstream file(path);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    fmt::print("{}", text);
}

}  // namespace

void check_methods(const std::string& option, const std::vector<std::string>& methods,
                   bool with_auto) {
    std::vector<std::string_view> known;
    for (const IntegratorInfo& info : integrator_catalogue()) known.push_back(info.name);
    if (with_auto) known.emplace_back("auto");
    for (const std::string& method : methods) {
        if (std::find(known.begin(), known.end(), method) != known.end()) continue;
        throw Error(ErrorKind::usage, {.key = option},
                    fmt::format("\"{}\" is no method{}", method, did_you_mean(method, known)),
                    "Run \"weft list integrators\" for all of them.");
    }
}

int lab_command(const LabCommandOptions& options) {
    Words words = sort_words(options.words);
    check_scenes(words);
    check_methods("--methods", options.methods, false);
    lab::StudyPlan plan;
    for (const std::string& name : words.scenes) plan.scenes.push_back(load_named(options, name));
    plan.experiments = words.experiments;
    plan.directory = directory_of(options, plan.scenes);
    plan.arguments = arguments_of(options, words);
    LabProgressLine line(!options.quiet && !options.json);
    plan.options = {options.quick, options.threads, options.methods,
                    [&](const lab::LabProgress& progress) { line.show(progress); }, interrupted};
    watch_for_interrupt();
    try {
        const std::vector<std::filesystem::path> files = lab::run_study(plan);
        line.end();
        if (options.json) {
            print_file(plan.directory / "lab.json");
        } else if (!options.quiet) {
            fmt::print("{} files; open {}\n", files.size(),
                       (plan.directory / "report.html").string());
        }
    } catch (const lab::Interrupted&) {
        line.end();
        fmt::print(stderr,
                   "weft: interrupted; what was measured is kept in {}: the same command goes on "
                   "from there\n",
                   plan.directory.string());
        return exit_interrupted;
    }
    return exit_done;
}

}  // namespace weft
