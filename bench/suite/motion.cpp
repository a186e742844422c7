#include "bench/suite/motion.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "bench/suite/falling_sheet.h"
#include "bench/suite/median.h"
#include "weft/error.h"

namespace weft::bench {

namespace {

constexpr int size = 33, frames = 30;
constexpr double frames_per_second = 60.0;

// At 0.9 of the largest stable step, or so many times finer.
int stable_steps(std::string_view method, double finer, double fraction) {
    const double limit = Simulation(falling_sheet(size, method)).stable_step(method);
    return static_cast<int>(std::ceil(finer / (frames_per_second * fraction * limit)));
}

Simulation start(std::string_view method, std::optional<int> steps_per_frame,
                 std::optional<double> tolerance) {
    SceneDescription scene = falling_sheet(size, method);
    if (steps_per_frame) {
        scene.integrator.time_step = 1.0 / (frames_per_second * *steps_per_frame);
    }
    scene.integrator.tolerance = tolerance;
    return let_fall(scene);
}

// @return seconds
double fall(Simulation& simulation) {
    const auto began = std::chrono::steady_clock::now();
    for (int n = 0; n < frames; ++n) {
        const FrameReport report = simulation.advance_frame();
        if (!report.ok()) throw Error(ErrorKind::diverged, {}, report.divergence->message);
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

std::vector<Vec3d> positions(const Simulation& simulation) {
    FrameBuffer buffer;
    simulation.capture(buffer);
    return buffer.positions;
}

double rms_distance(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
    double squared = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p) squared += dot(a[p] - b[p], a[p] - b[p]);
    return std::sqrt(squared / static_cast<double>(a.size()));
}

// Steps of a method's own choosing are counted by itself.
double steps_per_frame(const Simulation& simulation) {
    const std::size_t own = simulation.solver_counts().steps;
    return static_cast<double>(own > 0 ? own : simulation.step_count()) / frames;
}

MotionFigures figures_of(const MotionEntry& entry, const MotionReference& reference,
                         std::vector<double>& ms) {
    const bool limited = !entry.steps_per_frame && !entry.tolerance;
    Simulation simulation =
        start(entry.method, limited ? stable_steps(entry.method, 1.0, 0.9) : entry.steps_per_frame,
              entry.tolerance);
    const double energy = simulation.energy().total();
    ms.push_back(1e3 * fall(simulation) / frames);
    return {steps_per_frame(simulation), rms_distance(positions(simulation), reference.positions),
            simulation.energy().total() - energy, ms.back()};
}

}  // namespace

std::vector<MotionEntry> motion_entries() {
    std::vector<MotionEntry> entries;
    const auto add = [&](std::string_view method, std::optional<int> steps,
                         std::optional<double> tolerance, const std::string& after) {
        const Label label{fmt::format("motion {}{}", method, after), size, size, Precision::f64, 1};
        entries.push_back({method, steps, tolerance, label});
    };
    const auto add_steps = [&](std::string_view method, std::initializer_list<int> all) {
        for (const int steps : all) add(method, steps, {}, fmt::format(" {}", steps));
    };
    add("symplectic-euler", {}, {}, "");
    add("velocity-verlet", {}, {}, "");
    add_steps("implicit-midpoint", {1, 4});
    add_steps("implicit-euler", {1, 4, 16});
    add_steps("tr-bdf2", {1, 2, 4});
    add_steps("bdf2", {2, 4});
    add_steps("trapezoidal", {4});
    add_steps("sdirk2", {2, 4});
    add_steps("baraff-witkin", {1});
    add_steps("xpbd", {10, 20, 50, 100});
    add_steps("vbd", {10, 50});
    add_steps("projective-dynamics", {1, 4});
    add("dopri5", {}, 1e-3, " 1e-3");
    add("dopri5", {}, 1e-4, " 1e-4");
    add("dopri5", {}, 1e-5, " 1e-5");
    return entries;
}

MotionReference motion_reference() {
    Simulation simulation =
        start("velocity-verlet", stable_steps("velocity-verlet", 16.0, 1.0), std::nullopt);
    fall(simulation);
    return {positions(simulation), simulation.energy().kinetic};
}

std::optional<MotionRow> time_motion(const MotionEntry& entry, const MotionReference& reference,
                                     int repeats, const std::function<bool()>& stop) {
    MotionRow row{entry.label, {}, {}};
    std::vector<double> ms;
    try {
        for (int n = 0; n < repeats; ++n) {
            if (stop()) return std::nullopt;
            row.figures = figures_of(entry, reference, ms);
        }
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::diverged) throw;
        row.figures.reset();
        row.note = error.what();
        return row;
    }
    row.figures->ms_per_frame = median(std::move(ms));
    return row;
}

}  // namespace weft::bench
