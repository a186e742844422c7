// The weft command: parses the command line and calls one function of commands.h.
#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>
#include <new>
#include <system_error>

#include "cli/commands.h"
#include "weft/error.h"
#include "weft/instruction_set.h"
#include "weft/simulation.h"

namespace weft {

SceneDescription load_scene(const SceneOptions& options) {
    std::vector<SceneOverride> overrides;
    for (const std::string& setting : options.set) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw Error(
                ErrorKind::usage, {.key = "--set " + setting}, "must have the form KEY=VALUE",
                "For example: --set integrator.method=rk4 --set cloth.resolution=[100,100]");
        }
        overrides.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
    }
    SceneDescription scene = load_scene(options.scene, overrides);
    if (options.settle) scene.output.settle = true;
    if (options.frames || options.settle) {
        scene.output.duration =
            static_cast<double>(options.frames.value_or(0)) / scene.output.frames_per_second;
    }
    return scene;
}

namespace {

constexpr std::size_t most_frames = 100'000'000;
constexpr int most_threads = 1024;

void add_set(CLI::App& command, std::vector<std::string>& set, const char* help) {
    command.add_option("--set", set, help)->type_name("KEY=VALUE")->allow_extra_args(false);
}

void add_scene(CLI::App& command, SceneOptions& options, const char* help) {
    command.add_option("SCENE", options.scene, help)->required();
    add_set(command, options.set, "Set a key of the scene: --set integrator.method=rk4");
}

void add_frames(CLI::App& command, SceneOptions& options) {
    command.add_option("--frames", options.frames, "Simulate N frames (instead of the duration)")
        ->type_name("N")
        ->check(CLI::Range(std::size_t{0}, most_frames));
}

void add_threads(CLI::App& command, SceneOptions& options) {
    command.add_option("--threads", options.threads, "Threads to use; the result is the same")
        ->type_name("N")
        ->check(CLI::Range(1, most_threads));
}

class CommandLine {
public:
    CommandLine() {
        app_.set_version_flag("--version", "weft " + std::string(version()));
        app_.require_subcommand(1);
        app_.add_option_function<std::string>(
                "--simd", [](const std::string& name) { use_instruction_set(name); },
                "Vector instructions to use: scalar, sse4, avx2, avx512 (default: the best that "
                "the machine has, or WEFT_SIMD)")
            ->type_name("NAME");
        app_.fallthrough();
        app_.footer(
            "Examples:\n"
            "  weft run flag                          simulate the shipped flag into "
            "weft-out/flag\n"
            "  weft run my.toml --set wind.velocity=[12,0,0] -o out\n"
            "  weft view flag                         fly it in a window, and touch it\n"
            "  weft render flag -o flag.mp4           make a video of it\n"
            "  weft check sheet                       what is stable, and how large the scene is\n"
            "  weft lab --quick sheet                 measure every method on it; report.html\n"
            "Exit status: 0 done, 1 diverged, 2 wrong command line or scene, 3 reading or writing\n"
            "failed, 130 interrupted.");
        add_run();
        add_view();
        add_render();
        add_check();
        add_lab();
        add_bench();
        add_list();
    }

    int parse_and_run(int argc, char** argv) {
        try {
            app_.parse(argc, argv);
        } catch (const CLI::Success& success) {  // --help, --version
            return app_.exit(success);
        } catch (const CLI::ParseError& error) {
            fmt::print(stderr, "weft: {}\nRun \"weft --help\" or \"weft COMMAND --help\".\n",
                       error.what());
            return exit_usage;
        }
        return action_();
    }

private:
    void add_run() {
        CLI::App* command = app_.add_subcommand("run", "Simulate a scene and record it");
        add_scene(*command, run_, "Scene file, or the name of a shipped scene (weft list scenes)");
        command->add_option("-o,--output", run_.directory, "Directory (default weft-out/NAME)")
            ->type_name("DIR");
        add_frames(*command, run_);
        command->add_flag("--settle", run_.settle,
                          "Begin at rest (output.settle = true); without --frames, record that "
                          "alone");
        add_threads(*command, run_);
        CLI::Option* quiet =
            command->add_flag("--quiet", run_.quiet, "Say nothing unless something goes wrong");
        command->add_flag("--json", run_.json, "Print summary.json on standard output")
            ->excludes(quiet);
        command->callback([this] { action_ = [this] { return run_command(run_); }; });
    }
    void add_view() {
        CLI::App* command = app_.add_subcommand(
            "view", "Open a window: watch, touch and change a cloth as it flies");
        command->add_option("SCENE", view_.scene,
                            "Scene file, shipped scene, or recording (.pc2, .mdd, .glb); default: "
                            "the shipped flag");
        add_set(*command, view_.set,
                "Set a key of the scene: --set integrator.method=rk4; of a recording, keys of "
                "[render]");
        command
            ->add_option("--compare", view_.compare,
                         "Fly the same scene by these as well, at most three: --compare "
                         "rk4,implicit-euler")
            ->type_name("METHODS")
            ->delimiter(',')
            ->allow_extra_args(false);
        command->add_flag("--paused", view_.paused, "Wait for the space bar");
        add_threads(*command, view_);
        command->add_flag("--json", view_.json,
                          "When the window closes, print what happened in it");
        command->callback([this] { action_ = [this] { return view_command(view_); }; });
    }
    void add_render() {
        CLI::App* command =
            app_.add_subcommand("render", "Make a video or a picture of a scene or a recording");
        add_scene(*command, render_,
                  "Scene file, shipped scene, or recording (.pc2, .mdd, .glb; keys of [render] can "
                  "be set)");
        command->add_option("-o,--output", render_.file, "File: .mp4, .webm, .gif or .png")
            ->required()
            ->type_name("FILE");
        command->add_option("--frame", render_.frame, "For a .png: which frame (default: the last)")
            ->type_name("N")
            ->check(CLI::Range(std::size_t{0}, most_frames));
        add_frames(*command, render_);
        add_threads(*command, render_);
        command->add_flag("--quiet", render_.quiet, "Say nothing unless something goes wrong");
        command->callback([this] { action_ = [this] { return render_command(render_); }; });
    }
    void add_check() {
        CLI::App* command = app_.add_subcommand(
            "check", "Validate a scene: size, largest frequency, stable steps; simulates nothing");
        add_scene(*command, check_, "Scene file, or the name of a shipped scene");
        command->add_flag("--json", check_.json, "Print a JSON object");
        command->callback([this] { action_ = [this] { return check_command(check_); }; });
    }
    void add_lab() {
        CLI::App* command = app_.add_subcommand(
            "lab", "The laboratory: measure the methods on a scene, and write a report");
        command->add_option("EXPERIMENT|SCENE", lab_.words,
                            "Experiments (weft list experiments; default: all), and a scene "
                            "(default: sheet); or \"compare\" and two scenes");
        add_set(*command, lab_.set, "Set a key of the scene: --set cloth.resolution=[9,9]");
        command
            ->add_option("-o,--output", lab_.directory,
                         "Directory (default weft-lab/NAME); a study that was interrupted goes on")
            ->type_name("DIR");
        command->add_option("--methods", lab_.methods, "Only these: --methods verlet,rk4")
            ->type_name("NAMES")
            ->delimiter(',')
            ->allow_extra_args(false);
        command->add_flag("--quick", lab_.quick, "Fewer and shorter runs: under a minute");
        command->add_option("--threads", lab_.threads, "Runs at a time; the result is the same")
            ->type_name("N")
            ->check(CLI::Range(1, most_threads));
        CLI::Option* quiet =
            command->add_flag("--quiet", lab_.quiet, "Say nothing unless something goes wrong");
        command->add_flag("--json", lab_.json, "Print lab.json on standard output")
            ->excludes(quiet);
        command->callback([this] { action_ = [this] { return lab_command(lab_); }; });
    }
    void add_bench() {
        CLI::App* command =
            app_.add_subcommand("bench", "Speed on this machine, beside the peers built in");
        command->add_flag("--json", bench_.json, "Print a JSON object");
        CLI::Option* quick =
            command->add_flag("--quick", bench_.quick, "One repeat, and sizes up to 256x256");
        command->add_flag("--large", bench_.large, "64x64 to 4096x4096 besides: needs 8 GiB")
            ->excludes(quick);
        command
            ->add_option("--filter", bench_.filter,
                         "Only cases with all these words: --filter \"rk4 256x256 single\"")
            ->type_name("TEXT");
        command->add_option("--repeats", bench_.repeats, "Repeats of every timing (default 3 or 5)")
            ->type_name("N")
            ->check(CLI::Range(1, 1000));
        command->add_option("-o,--output", bench_.plot, "Plot of cost against size: .svg or .png")
            ->type_name("FILE");
        command->callback([this] { action_ = [this] { return bench_command(bench_); }; });
    }
    void add_list() {
        CLI::App* command = app_.add_subcommand("list", "List what weft knows");
        command
            ->add_option("WHAT", what_,
                         "integrators, fabrics, scenes, formats, experiments, or keys")
            ->required();
        command->add_flag("--json", list_json_, "Print a JSON object");
        command->callback([this] { action_ = [this] { return list_command(what_, list_json_); }; });
    }

    CLI::App app_{"weft: cloth simulation engine and integrator laboratory", "weft"};
    RunOptions run_;
    ViewOptions view_;
    RenderOptions render_;
    SceneOptions check_;
    LabCommandOptions lab_;
    BenchOptions bench_;
    std::string what_;
    bool list_json_ = false;
    std::function<int()> action_;
};

int exit_status(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::diverged:
            return exit_diverged;
        case ErrorKind::usage:
            return exit_usage;
        case ErrorKind::file:
            return exit_file;
    }
    return exit_usage;
}

int guarded_main(int argc, char** argv) {
    try {
        CommandLine command_line;
        return command_line.parse_and_run(argc, argv);
    } catch (const Error& error) {
        fmt::print(stderr, "weft: {}\n", error.what());
        if (!error.detail().empty()) fmt::print(stderr, "{}\n", error.detail());
        return exit_status(error.kind());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "weft: not enough memory for this scene\n");
        return exit_diverged;
    } catch (const std::system_error& error) {  // fmt::print where standard output takes no more
        fmt::print(stderr, "weft: standard output: {}\n", error.what());
        return exit_file;
    }
}

// What was printed is only written for certain when the buffer is flushed.
int after_flushing(int status) {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
    fmt::print(stderr, "weft: standard output: cannot be written: {}\n", std::strerror(errno));
    return exit_file;
}

}  // namespace

}  // namespace weft

int main(int argc, char** argv) {
    // What is freed after the analysis of a large cloth goes back to the system before the run
    // needs as much: glibc would keep it, having raised its threshold for blocks of their own.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
    return weft::after_flushing(weft::guarded_main(argc, argv));
}
