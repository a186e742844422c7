#include <fmt/format.h>

#include <chrono>
#include <exception>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/simulate.h"
#include "io/output_file.h"
#include "weft/error.h"

namespace weft {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Makes the output directory; one that is still empty when the run fails goes again.
class OutputDirectory {
public:
    explicit OutputDirectory(const std::filesystem::path& path) : path_(path) {
        std::error_code error;
        made_ = std::filesystem::create_directories(path, error);
        if (error) {
            throw file_error(path.string(), "cannot make this directory: " + error.message());
        }
    }
    ~OutputDirectory() {
        std::error_code not_empty;
        if (made_) std::filesystem::remove(path_, not_empty);
    }
    OutputDirectory(const OutputDirectory&) = delete;
    OutputDirectory& operator=(const OutputDirectory&) = delete;

private:
    std::filesystem::path path_;
    bool made_ = false;
};

void announce(const Simulation& simulation, const RunRecord& record) {
    const SceneDescription& scene = simulation.scene();
    fmt::print(stderr, "{}: {} particles, {}; frames: {}, steps a frame: {} of {:.4g} s\n",
               scene.name, simulation.particle_count(), simulation.method(), scene.frame_count(),
               simulation.steps_per_frame(), simulation.time_step());
    if (!simulation.method_reason().empty()) {
        fmt::print(stderr, "{} because {}\n", simulation.method(), simulation.method_reason());
    }
    if (simulation.settle_report()) {
        fmt::print(stderr, "{}\n", simulation.settle_report()->message);
    }
    for (const std::string& warning : record.warnings) fmt::print(stderr, "warning: {}\n", warning);
}

void write_summary(const std::filesystem::path& directory, const Simulation& simulation,
                   RunRecord& record, nlohmann::ordered_json& summary) {
    record.files.push_back(directory / "summary.json");
    summary = run_summary(simulation, record);
    OutputFile file(directory / "summary.json");
    file.write(summary.dump(2) + "\n");
    file.commit();
}

void conclude(const Simulation& simulation, const RunRecord& record, std::size_t known_warnings) {
    for (std::size_t n = known_warnings; n < record.warnings.size(); ++n) {
        fmt::print(stderr, "warning: {}\n", record.warnings[n]);
    }
    fmt::print("frames: {}; {:.2f} s simulated in {:.2f} s; state {:016x}\n", simulation.frame(),
               simulation.time(), record.total_seconds, simulation.state_hash());
    for (const std::filesystem::path& file : record.files) fmt::print("{}\n", file.string());
}

// Ends the recordings; a failure is kept until the summary is written.
std::exception_ptr finish(RecordingQueue& queue, RunRecord& record) {
    std::exception_ptr failure;
    try {
        queue.finish();
    } catch (...) {
        failure = std::current_exception();
        record.status = "failed";
    }
    record.files = queue.files();
    record.warnings.insert(record.warnings.end(), queue.warnings().begin(), queue.warnings().end());
    record.recording_seconds = queue.busy_seconds();
    return failure;
}

}  // namespace

int run_command(const RunOptions& options) {
    const Clock::time_point start = Clock::now();
    const SceneDescription scene = load_scene(options);
    RunRecord record;
    Simulation simulation(scene, options.threads);
    record.building_seconds = seconds_since(start);
    record.warnings = warnings_before(simulation);
    const std::size_t known_warnings = record.warnings.size();
    const bool talk = !options.quiet && !options.json;
    if (talk) announce(simulation, record);

    const std::filesystem::path directory = options.directory.empty()
                                                ? std::filesystem::path("weft-out") / scene.stem
                                                : std::filesystem::path(options.directory);
    const OutputDirectory output(directory);
    watch_for_interrupt();
    std::optional<RecordingQueue> queue;
    if (!scene.output.formats.empty()) {
        queue.emplace(make_recorders(scene.output.formats),
                      recording_plan(simulation, directory, scene.stem));
    }
    Progress progress(scene.frame_count(), talk);
    simulate(simulation, queue ? &*queue : nullptr, progress, record);
    record.warnings.insert(record.warnings.end(), simulation.warnings().begin(),
                           simulation.warnings().end());
    const std::exception_ptr failure = queue ? finish(*queue, record) : nullptr;
    record.total_seconds = seconds_since(start);

    nlohmann::ordered_json summary;
    try {
        write_summary(directory, simulation, record, summary);
    } catch (...) {
        if (!failure) throw;
    }
    if (failure) std::rethrow_exception(failure);
    if (options.json) {
        fmt::print("{}\n", summary.dump(2));
    } else if (!options.quiet) {
        conclude(simulation, record, known_warnings);
    }
    if (record.divergence) {
        report_divergence(*record.divergence);
        return exit_diverged;
    }
    return record.status == "interrupted" ? exit_interrupted : exit_done;
}

}  // namespace weft
