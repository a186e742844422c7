#include "simulation/settle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace weft {

namespace {

constexpr double first_tau = 1.0 / 60.0, least_tau = 1e-4, largest_tau = 1e3;  // [s]
constexpr double loosest = 0.1, tightest = 1e-6;                               // linear solves
constexpr double overshoot = 0.5;  // of the slope along a step, that it may end with

// A search for rest: the state, its unbalanced force b, and the step's length tau.
class Search {
public:
    Search(ImplicitSystem& system, double t, Vec3View<double> x)
        : system_(system), t_(t), x_(x), start_(x.size), v_(x.size), b_(x.size), d_(x.size) {
        evaluate();
    }

    [[nodiscard]] double largest_force() const { return std::sqrt(largest_squared_); }
    [[nodiscard]] std::size_t linear_iterations() const { return linear_iterations_; }
    [[nodiscard]] bool is_finite() const { return std::isfinite(largest_squared_); }

    // One Newton iteration of one implicit step. False: no way down.
    bool advance() {
        const double before = sum_of_squares_;
        system_.linearise(t_, 1.0 / tau_, x_, v_.view());
        const LinearReport linear = system_.solve(std::as_const(b_).view(), forcing_, d_.view());
        linear_iterations_ += static_cast<std::size_t>(linear.iterations);
        const double fraction = move();
        if (fraction == 0.0) return false;
        const double ratio = before > 0.0 ? sum_of_squares_ / before : 0.0;
        forcing_ = std::clamp(0.9 * ratio, tightest, loosest);
        // Switched evolution relaxation: as the force falls, the step grows.
        const double growth = fraction < 0.5 ? 0.5 : std::clamp(1.0 / std::sqrt(ratio), 1.2, 4.0);
        tau_ = std::clamp(tau_ * growth, least_tau, largest_tau);
        return true;
    }

    // A step from here with a tenth of the length; false: it is at its shortest.
    bool shorten() {
        if (tau_ <= least_tau) return false;
        tau_ = std::max(tau_ / 10.0, least_tau);
        return true;
    }

private:
    void evaluate() {
        v_.fill_zero();
        Vec3Array<double>& still = v_;
        system_.constrain(t_, x_, still.view());
        still.fill_zero();
        system_.acceleration(t_, x_, std::as_const(still).view(), b_.view());
        const auto w = system_.inverse_masses();
        largest_squared_ = sum_of_squares_ = 0.0;
        for (std::size_t s = 0; s < x_.size; ++s) {
            const Vec3d force = w[s] > 0.0 ? b_[s] / w[s] : Vec3d{};
            b_.set(s, force);
            const double squared = dot(force, force);
            largest_squared_ =
                squared > largest_squared_ || !std::isfinite(squared) ? squared : largest_squared_;
            sum_of_squares_ += squared;
        }
    }

    [[nodiscard]] double slope() const {
        double sum = 0.0;
        for (std::size_t s = 0; s < x_.size; ++s) sum += dot(b_[s], d_[s]);
        return sum;
    }

    // Along d, less far where that overshoots; as NewtonSolver does. 0: nowhere, x is as it was.
    double move() {
        const double first = slope();
        if (!(first > 0.0) || !std::isfinite(first)) return 0.0;
        for (std::size_t s = 0; s < x_.size; ++s) start_.set(s, x_[s]);
        double fraction = 1.0;
        for (int n = 0; n < 20; ++n) {
            for (std::size_t s = 0; s < x_.size; ++s) x_.set(s, start_[s] + fraction * d_[s]);
            evaluate();
            const double last = slope();
            if (last >= -overshoot * first) return fraction;
            fraction *= std::isfinite(last) ? std::clamp(first / (first - last), 0.1, 0.7) : 0.1;
        }
        for (std::size_t s = 0; s < x_.size; ++s) x_.set(s, start_[s]);
        evaluate();
        return 0.0;
    }

    ImplicitSystem& system_;
    double t_;
    Vec3View<double> x_;
    Vec3Array<double> start_, v_, b_, d_;
    double tau_ = first_tau, forcing_ = loosest;
    double largest_squared_ = 0.0, sum_of_squares_ = 0.0;
    std::size_t linear_iterations_ = 0;
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
                    Vec3View<double> x) {
    Search search(system, t, x);
    const double scale = weight > 0.0 ? weight : search.largest_force();
    const auto is_at_rest = [&] {
        return search.largest_force() <= limits.relative_residual * scale;
    };
    SettleReport report;
    while (!is_at_rest() && search.is_finite() &&
           report.newton_iterations < static_cast<std::size_t>(limits.max_iterations)) {
        ++report.newton_iterations;
        if (!search.advance() && !search.shorten()) break;
    }
    report.converged = is_at_rest();
    report.linear_iterations = search.linear_iterations();
    report.residual = search.largest_force();
    report.relative_residual = scale > 0.0 ? report.residual / scale : 0.0;
    report.message = message(report, weight);
    return report;
}

}  // namespace weft
