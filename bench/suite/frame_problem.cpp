#include "bench/suite/frame_problem.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "bench/suite/falling_sheet.h"
#include "integrators/newton.h"
#include "simulation/cloth_system.h"
#include "weft/error.h"
#include "weft/simulation.h"

namespace weft::bench {

namespace {

constexpr int frames_fallen = 30;
constexpr double march_tolerance = 1e-4;  // [m]
constexpr int march_iterations = 2000;

// Where cloth buckles a few particles may go on creeping for long: what counts is the rms.
constexpr double solution_tolerance = 1e-9, settled = 1e-6;  // [m]
constexpr int iterations_a_round = 50, most_rounds = 40;

SceneDescription scene_of(int size) {
    SceneDescription scene = falling_sheet(size, "implicit-euler");
    scene.integrator.time_step = FrameProblem::step;
    scene.integrator.tolerance = march_tolerance;
    scene.integrator.iterations = march_iterations;
    return scene;
}

Error failed(int size, const std::string& what) {
    return {ErrorKind::diverged,
            {.key = fmt::format("the falling sheet of {0}x{0}", size)},
            what,
            "So there is nothing to time the solvers on."};
}

}  // namespace

FrameProblem::FrameProblem(int size, const std::function<bool()>& stop)
    : scene_(scene_of(size)), cloth_(build_cloth(scene_)) {
    start_.x = start_.v = guess_ = solution_ = Vec3Array<double>(slot_count());
    march(stop);
    solve(stop);
}

void FrameProblem::march(const std::function<bool()>& stop) {
    Simulation simulation = let_fall(scene_);
    for (int n = 0; n < frames_fallen; ++n) {
        if (stop()) return;
        const FrameReport report = simulation.advance_frame();
        if (!report.ok()) throw failed(cloth_.grid->resolution[0], report.divergence->message);
    }
    FrameBuffer buffer;
    simulation.capture(buffer);
    start_.time = simulation.time();
    cloth_.layout.for_each([&](std::size_t p, std::size_t slot) {
        start_.x.set(slot, buffer.positions[p]);
        start_.v.set(slot, buffer.velocities[p]);
        guess_.set(slot, buffer.positions[p] + step * buffer.velocities[p]);
    });
}

void FrameProblem::solve(const std::function<bool()>& stop) {
    ClothSystem<double> cloth_system(cloth_, scene_);
    ImplicitSystem& system = *cloth_system.implicit_system();
    const ImplicitStage stage{start_.time + step, step, std::as_const(start_.x).view(),
                              std::as_const(start_.v).view()};
    NewtonSolver newton;
    newton.prepare(slot_count());
    Vec3Array<double> x = guess_, v(slot_count());
    const auto iterate = [&](int iterations) {
        return newton.solve(system, stage, {solution_tolerance, iterations}, x, v);
    };
    const double first_residual = iterate(0).residual;
    double moved = 0.0;
    for (int round = 0; round < most_rounds; ++round) {
        if (stop()) return;
        solution_ = x;
        const NewtonReport report = iterate(iterations_a_round);
        moved = error(std::as_const(x).view());
        solution_ = x;
        residual_ = report.residual / first_residual;
        if (report.converged || moved < settled) return;
    }
    throw failed(cloth_.grid->resolution[0],
                 fmt::format("Newton did not converge: after {} iterations, particles still move "
                             "{:.2g} m (rms) in {}",
                             most_rounds * iterations_a_round, moved, iterations_a_round));
}

double FrameProblem::error(ConstVec3View<double> x) const {
    double squared = 0.0;
    const auto solution = solution_.view();
    cloth_.layout.for_each([&](std::size_t, std::size_t slot) {
        const Vec3d d = x[slot] - solution[slot];
        squared += dot(d, d);
    });
    return std::sqrt(squared / static_cast<double>(cloth_.particle_count));
}

}  // namespace weft::bench
