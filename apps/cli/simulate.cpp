#include "cli/simulate.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "cli/interrupt.h"

namespace weft {

namespace {

// Adds the time from its construction to its destruction to a sum of seconds.
class Stopwatch {
public:
    explicit Stopwatch(double& seconds) : seconds_(seconds) {}
    ~Stopwatch() {
        seconds_ +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

bool record_frame(const Simulation& simulation, RecordingQueue* queue, RunRecord& record) {
    const Stopwatch stopwatch(record.waiting_seconds);
    const SpringStrain strain = simulation.largest_strain();
    if (std::abs(strain.strain) > std::abs(record.largest_strain.strain) ||
        simulation.frame() == 0) {
        record.largest_strain = strain;
        record.largest_strain_frame = simulation.frame();
    }
    if (queue == nullptr) return true;
    simulation.capture(queue->next(), queue->needs());
    return queue->push();
}

}  // namespace

void simulate(Simulation& simulation, RecordingQueue* queue, Progress& progress,
              RunRecord& record) {
    record.start_energy = simulation.energy();
    const std::size_t last = simulation.scene().frame_count();
    if (!record_frame(simulation, queue, record)) record.status = "failed";
    while (record.status == "done" && simulation.frame() < last) {
        if (interrupted()) {
            record.status = "interrupted";
            break;
        }
        FrameReport report;
        {
            const Stopwatch stopwatch(record.stepping_seconds);
            report = simulation.advance_frame();
        }
        record.halvings += report.halvings;
        if (!report.ok()) {
            record.status = "diverged";
            record.divergence = report.divergence;
        } else if (!record_frame(simulation, queue, record)) {
            record.status = "failed";
        }
        progress.update(simulation);
    }
    progress.end();
}

std::vector<std::string> warnings_before(const Simulation& simulation) {
    std::vector<std::string> warnings;
    const std::string_view method = simulation.method();
    const double stable = simulation.stable_step(method);
    if (simulation.time_step() > stable) {
        warnings.push_back(
            stable > 0.0
                ? fmt::format("the step of {:.4g} s is beyond the stable {:.4g} s of {} on this "
                              "cloth: expect it to blow up",
                              simulation.time_step(), stable, method)
                : fmt::format("{} is stable at no step on this undamped cloth: it will gain energy "
                              "until it blows up",
                              method));
    }
    return warnings;
}

RecordingPlan recording_plan(const Simulation& simulation, const std::filesystem::path& directory,
                             const std::string& stem) {
    const SceneDescription& scene = simulation.scene();
    RecordingPlan plan;
    plan.directory = directory;
    plan.stem = stem;
    plan.title = scene.name;
    plan.surface = &simulation.surface();
    plan.frame_count = scene.frame_count() + 1;
    plan.frames_per_second = scene.output.frames_per_second;
    plan.precision = scene.integrator.precision;
    plan.render = scene.render;
    plan.obstacles = scene.obstacles;
    return plan;
}

void report_divergence(const Divergence& divergence) {
    fmt::print(stderr, "weft: {}\n{}\n", divergence.message, divergence.advice);
}

}  // namespace weft
