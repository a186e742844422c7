#include <chrono>
#include <utility>

#include "bench/suite/frame_solvers.h"
#include "integrators/integrator.h"
#include "simulation/cloth_system.h"
#include "weft/error.h"

namespace weft::bench {

namespace {

// A number of iterations with its matrix factored.
class FixedIterations {
public:
    FixedIterations(const FrameProblem& problem, ClothSystem<double>& system, int iterations)
        : problem_(problem), system_(system), state_(problem.start()) {
        IntegratorSettings settings;
        settings.tolerance = 0.0;
        settings.iterations = iterations;
        integrator_ = make_integrator<double>("projective-dynamics", settings);
        integrator_->prepare(system_);
        run();
    }

    // Sets error().
    // @return seconds
    double run() {
        state_.x = problem_.start().x;
        state_.v = problem_.start().v;
        state_.time = problem_.start().time;
        const auto began = std::chrono::steady_clock::now();
        const StepReport report = integrator_->step(system_, FrameProblem::step, state_);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        if (!report.ok()) throw Error(ErrorKind::diverged, {}, report.failure->reason);
        error_ = problem_.error(std::as_const(state_.x).view());
        return seconds;
    }
    [[nodiscard]] double error() const { return error_; }

private:
    const FrameProblem& problem_;
    ClothSystem<double>& system_;
    std::unique_ptr<Integrator<double>> integrator_;
    ParticleState<double> state_;
    double error_ = 0.0;
};

class ProjectiveFrame final : public FrameSolver {
public:
    ProjectiveFrame(const FrameProblem& problem, double most_seconds)
        : problem_(problem), system_(problem.cloth(), problem.scene()) {
        Found found{0, 1, nullptr};
        for (std::size_t n = 0; n < frame_marks.size(); ++n) {
            find(found, frame_marks[n], most_seconds);
            if (!found.run) break;
            iterations_[n] = found.iterations;
            runs_[n] = found.run;
        }
    }

    FrameTiming measure() override {
        FrameTiming timing;
        for (std::size_t n = 0; n < runs_.size(); ++n) {
            if (runs_[n]) timing.marks[n] = {runs_[n]->run(), iterations_[n], 0};
        }
        return timing;
    }

private:
    // `iterations` reach the mark (null: do not, in the time allowed), `too_few` do not.
    struct Found {
        int too_few = 0, iterations = 1;
        std::shared_ptr<FixedIterations> run;
    };

    // Doubles the iterations until they reach the mark, then halves the interval to a tenth.
    void find(Found& found, double mark, double most_seconds) {
        const auto attempt = [&](int iterations) {
            return std::make_shared<FixedIterations>(problem_, system_, iterations);
        };
        if (!found.run) found.run = attempt(found.iterations);
        while (!(found.run->error() < mark)) {
            if (found.run->run() > most_seconds) {
                found.run = nullptr;
                return;
            }
            found.too_few = found.iterations;
            found.iterations *= 2;
            found.run = attempt(found.iterations);
        }
        while (found.iterations - found.too_few > 1 + found.iterations / 10) {
            const int middle = (found.iterations + found.too_few) / 2;
            auto run = attempt(middle);
            if (run->error() < mark) {
                found.iterations = middle;
                found.run = std::move(run);
            } else {
                found.too_few = middle;
            }
        }
    }

    const FrameProblem& problem_;
    ClothSystem<double> system_;
    std::array<int, frame_marks.size()> iterations_{};
    std::array<std::shared_ptr<FixedIterations>, frame_marks.size()> runs_;
};

}  // namespace

std::unique_ptr<FrameSolver> make_projective(const FrameProblem& problem, double most_seconds) {
    return std::make_unique<ProjectiveFrame>(problem, most_seconds);
}

}  // namespace weft::bench
