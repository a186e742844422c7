#include "simulation/settle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "integrators/newton.h"

namespace weft {

namespace {

constexpr double first_tau = 1.0 / 60.0, least_tau = 1e-4, largest_tau = 1e4;  // [s]
constexpr double growth = 2.0;  // of tau, from step to step
constexpr double enough = 0.5;  // of the largest force: what a step is solved to

// Newton's at most, in one implicit step: what takes more is better begun anew, and shorter.
constexpr int iterations_a_step = 20;

double longest(const Vec3Array<double>& array) {
    double longest = 0.0;
    for (std::size_t s = 0; s < array.size(); ++s) {
        const double here = length(array[s]);
        if (!(here <= longest)) longest = here;  // not finite: stays so
    }
    return longest;
}

// A search for rest by implicit steps from a standing start.
class Search {
public:
    Search(ImplicitSystem& system, double t, Vec3Array<double>& x)
        : system_(system), t_(t), x_(x), start_(x), still_(x.size()), v_(x.size()), b_(x.size()) {
        newton_.prepare(x.size());
    }

    // The largest unbalanced force on a particle at rest in x [N].
    double largest_force() {
        system_.constrain(t_, x_.view(), v_.view());
        system_.acceleration(t_, std::as_const(x_).view(), std::as_const(still_).view(), b_.view());
        const auto w = system_.inverse_masses();
        for (std::size_t s = 0; s < b_.size(); ++s) b_.set(s, w[s] > 0.0 ? b_[s] / w[s] : Vec3d{});
        return longest(b_);
    }

    // A step of tau, which ends where no force is larger than `force`.
    NewtonReport step(double tau, double force, int most_iterations) {
        start_ = x_;
        NewtonLimits limits;
        limits.tolerance = 0.0;
        limits.force = force;
        limits.max_iterations = std::min(iterations_a_step, most_iterations);
        const ImplicitStage stage{t_, tau, std::as_const(start_).view(),
                                  std::as_const(still_).view()};
        return newton_.solve(system_, stage, limits, x_, v_);
    }

private:
    ImplicitSystem& system_;
    double t_;
    Vec3Array<double>& x_;
    Vec3Array<double> start_, still_, v_, b_;
    NewtonSolver newton_;
};

std::string message(const SettleReport& report, double weight) {
    const std::string end =
        fmt::format("after {} Newton iterations: largest unbalanced force {:.2g} N, {:.2g} of {}",
                    report.newton_iterations, report.residual, report.relative_residual,
                    weight > 0.0 ? "a particle's mean weight" : "the first");
    return (report.converged ? "at rest " : "no rest found ") + end;
}

}  // namespace

SettleReport settle(ImplicitSystem& system, double t, double weight, const SettleLimits& limits,
                    Vec3Array<double>& x) {
    Search search(system, t, x);
    SettleReport report;
    report.residual = search.largest_force();
    const double scale = weight > 0.0 ? weight : report.residual;
    const double force = limits.relative_residual * scale;
    double tau = first_tau;
    while (report.residual > force &&
           report.newton_iterations < static_cast<std::size_t>(limits.max_iterations)) {
        const int left = limits.max_iterations - static_cast<int>(report.newton_iterations);
        const NewtonReport step =
            search.step(tau, std::max(force / 2.0, enough * report.residual), left);
        report.newton_iterations += static_cast<std::size_t>(step.iterations);
        report.linear_iterations += static_cast<std::size_t>(step.linear_iterations);
        if (step.iterations == 0) break;  // forces that are not finite
        report.residual = search.largest_force();
        // What is solved may be followed by a longer step; what is not was too long.
        tau = std::clamp(step.converged ? tau * growth : tau / growth, least_tau, largest_tau);
    }
    report.converged = report.residual <= force;
    report.relative_residual = scale > 0.0 ? report.residual / scale : 0.0;
    report.message = message(report, weight);
    return report;
}

}  // namespace weft
