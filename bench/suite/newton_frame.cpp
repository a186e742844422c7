#include <chrono>
#include <utility>

#include "bench/suite/frame_solvers.h"
#include "integrators/newton.h"
#include "simulation/cloth_system.h"

namespace weft::bench {

namespace {

// A clock that can be stopped.
class StopWatch {
public:
    void go() { began_ = std::chrono::steady_clock::now(); }
    void stop() {
        seconds_ +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
    }
    [[nodiscard]] double seconds() const { return seconds_; }

private:
    std::chrono::steady_clock::time_point began_;
    double seconds_ = 0.0;
};

// Ends a solution that has come near enough, or takes too long.
struct Enough {};

// A system that is asked for a new matrix once an iteration, with the positions reached: there the
// watch stands still while the error is looked at.
class TracedSystem final : public ImplicitSystem {
public:
    TracedSystem(const FrameProblem& problem, ImplicitSystem& system, double most_seconds)
        : problem_(problem), system_(system), most_seconds_(most_seconds) {}

    void acceleration(double t, ConstVec3View<double> x, ConstVec3View<double> v,
                      Vec3View<double> a) override {
        system_.acceleration(t, x, v, a);
    }
    void constrain(double t, Vec3View<double> x, Vec3View<double> v) const override {
        system_.constrain(t, x, v);
    }
    [[nodiscard]] std::span<const double> inverse_masses() const override {
        return system_.inverse_masses();
    }
    void linearise(double t, double inverse_tau, ConstVec3View<double> x,
                   ConstVec3View<double> v) override {
        watch_.stop();
        look_at(x);
        if (timing_.marks.back() || watch_.seconds() > most_seconds_) throw Enough{};
        ++iterations_;
        watch_.go();
        system_.linearise(t, inverse_tau, x, v);
    }
    LinearReport solve(ConstVec3View<double> r, double tolerance, Vec3View<double> d) override {
        const LinearReport report = system_.solve(r, tolerance, d);
        linear_iterations_ += report.iterations;
        return report;
    }

    void begin() { watch_.go(); }
    FrameTiming end(ConstVec3View<double> x) {
        watch_.stop();
        look_at(x);
        return timing_;
    }
    [[nodiscard]] const FrameTiming& timing() const { return timing_; }

private:
    void look_at(ConstVec3View<double> x) {
        const double error = problem_.error(x);
        for (std::size_t n = 0; n < frame_marks.size(); ++n) {
            if (timing_.marks[n] || !(error < frame_marks[n])) continue;
            timing_.marks[n] = {watch_.seconds(), iterations_, linear_iterations_};
        }
    }

    const FrameProblem& problem_;
    ImplicitSystem& system_;
    double most_seconds_;
    StopWatch watch_;
    int iterations_ = 0, linear_iterations_ = 0;
    FrameTiming timing_;
};

class NewtonFrame final : public FrameSolver {
public:
    NewtonFrame(const FrameProblem& problem, LinearSolver linear_solver, double most_seconds)
        : problem_(problem),
          scene_(with(problem.scene(), linear_solver)),
          system_(problem.cloth(), scene_),
          most_seconds_(most_seconds),
          x_(problem.slot_count()),
          v_(problem.slot_count()) {
        newton_.prepare(problem.slot_count());
        x_ = problem_.guess();
        solve(*system_.implicit_system(), {.tolerance = 0.0, .max_iterations = 1});
    }

    FrameTiming measure() override {
        constexpr NewtonLimits limits{.tolerance = 1e-9, .max_iterations = 2000};
        TracedSystem traced(problem_, *system_.implicit_system(), most_seconds_);
        x_ = problem_.guess();
        traced.begin();
        try {
            solve(traced, limits);
        } catch (const Enough&) {
            return traced.timing();
        }
        return traced.end(std::as_const(x_).view());
    }

private:
    static SceneDescription with(SceneDescription scene, LinearSolver linear_solver) {
        scene.integrator.linear_solver = linear_solver;
        return scene;
    }

    void solve(ImplicitSystem& system, const NewtonLimits& limits) {
        const ParticleState<double>& start = problem_.start();
        const double h = FrameProblem::step;
        newton_.solve(system, {start.time + h, h, start.x.view(), start.v.view()}, limits, x_, v_);
    }

    const FrameProblem& problem_;
    SceneDescription scene_;
    ClothSystem<double> system_;
    double most_seconds_;
    NewtonSolver newton_;
    Vec3Array<double> x_, v_;
};

}  // namespace

std::unique_ptr<FrameSolver> make_newton(const FrameProblem& problem, LinearSolver linear_solver,
                                         double most_seconds) {
    return std::make_unique<NewtonFrame>(problem, linear_solver, most_seconds);
}

}  // namespace weft::bench
