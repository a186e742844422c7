#include "integrators/newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/dot_product.h"

namespace weft {

namespace {

constexpr double first_forcing = 0.3;    // of the first linear solve, and the loosest
constexpr double least_forcing = 1e-8;   // inner solves are in float: tighter is refinement
constexpr double single_forcing = 1e-4;  // where there is no second solve to mend the first
constexpr int patience = 250;            // iterations; few solutions take as many ...
constexpr double late_forcing = 1e-2;    // ... then mixing learns from exacter directions
constexpr double overshoot = 0.5;        // of the slope, that a step may end with
constexpr int max_shortenings = 30;
constexpr std::size_t remembered_changes = 12;  // ten failed on a flag in long steps

// to = from + fraction by
void move(ConstVec3View<double> from, double fraction, ConstVec3View<double> by,
          Vec3View<double> to) {
    const auto component = [&](const double* start, const double* d, double* end) {
        for (std::size_t s = 0; s < to.size; ++s) end[s] = start[s] + fraction * d[s];
    };
    component(from.x, by.x, to.x);
    component(from.y, by.y, to.y);
    component(from.z, by.z, to.z);
}

// v = (x - x0) / tau, and pins in their places.
void set_velocity(const ImplicitSystem& system, const ImplicitStage& stage, Vec3View<double> x,
                  Vec3View<double> v) {
    const double per_tau = 1.0 / stage.tau;
    const auto component = [&](const double* at, const double* from, double* out) {
        for (std::size_t s = 0; s < x.size; ++s) out[s] = per_tau * (at[s] - from[s]);
    };
    component(x.x, stage.x0.x, v.x);
    component(x.y, stage.x0.y, v.y);
    component(x.z, stage.x0.z, v.z);
    system.constrain(stage.t, x, v);
}

// Not finite where one of them is not.
double longest(const Vec3Array<double>& d) {
    const auto view = d.view();
    double squared = 0.0;
    for (std::size_t s = 0; s < view.size; ++s) {
        const double here = view.x[s] * view.x[s] + view.y[s] * view.y[s] + view.z[s] * view.z[s];
        if (!(here <= squared)) squared = here;
        if (std::isnan(squared)) break;
    }
    return std::sqrt(squared);
}

}  // namespace

void NewtonSolver::prepare(std::size_t slots) {
    b_ = d_ = plain_ = start_ = Vec3Array<double>(slots);
    mixing_ = AndersonMixing(slots, remembered_changes);
}

void NewtonSolver::evaluate(ImplicitSystem& system, const ImplicitStage& stage, Vec3View<double> x,
                            Vec3View<double> v) {
    const double per_tau = 1.0 / stage.tau;
    set_velocity(system, stage, x, v);
    ++report_.evaluations;
    const auto b = b_.view();
    system.acceleration(stage.t, x, v, b);
    const double* const w = system.inverse_masses().data();
    // m (a - (v - v0) / tau), where v is already (x - x0) / tau.
    const auto unbalanced = [&](double* out, const double* now, const double* before) {
        for (std::size_t s = 0; s < x.size; ++s) {
            const double lacking = out[s] - per_tau * (now[s] - before[s]);
            out[s] = w[s] > 0.0 ? lacking / w[s] : 0.0;
        }
    };
    unbalanced(b.x, v.x, stage.v0.x);
    unbalanced(b.y, v.y, stage.v0.y);
    unbalanced(b.z, v.z, stage.v0.z);
}

double NewtonSolver::find_direction(ImplicitSystem& system, double forcing) {
    const LinearReport linear = system.solve(std::as_const(b_).view(), forcing, d_.view());
    report_.linear_iterations += linear.iterations;
    report_.linear_converged = linear.converged;
    report_.linear_residual = linear.residual;
    return dot(b_, d_);
}

bool NewtonSolver::move_along(ImplicitSystem& system, const ImplicitStage& stage, double slope,
                              Vec3Array<double>& x, Vec3Array<double>& v) {
    if (!(slope > 0.0) || !std::isfinite(slope)) return false;
    start_ = x;
    double fraction = 1.0;
    for (int n = 0; n < max_shortenings; ++n) {
        move(start_.view(), fraction, std::as_const(d_).view(), x.view());
        evaluate(system, stage, x.view(), v.view());
        const double end_slope = dot(b_, d_);
        if (end_slope >= -overshoot * slope) {
            report_.displacement = fraction * longest(d_);
            return true;
        }
        // Where a parabola through both slopes is lowest.
        const double secant = slope / (slope - end_slope);
        fraction *= std::isfinite(end_slope) ? std::clamp(secant, 0.1, 0.7) : 0.1;
    }
    report_.displacement = 0.0;
    return false;
}

bool NewtonSolver::iterate(ImplicitSystem& system, const ImplicitStage& stage, double forcing,
                           Vec3Array<double>& x, Vec3Array<double>& v) {
    ++report_.iterations;
    system.linearise(stage.t, 1.0 / stage.tau, std::as_const(x).view(), std::as_const(v).view());
    double slope = find_direction(system, forcing);
    plain_ = d_;
    mixing_.mix(x, d_);
    if (const double mixed = dot(b_, d_); mixed > 0.0) {
        slope = mixed;
    } else {
        d_ = plain_;  // what was remembered misleads here
        mixing_.clear();
    }
    return move_along(system, stage, slope, x, v);
}

NewtonReport NewtonSolver::solve(ImplicitSystem& system, const ImplicitStage& stage,
                                 const NewtonLimits& limits, Vec3Array<double>& x,
                                 Vec3Array<double>& v) {
    report_ = {};
    mixing_.clear();
    evaluate(system, stage, x.view(), v.view());
    double squared = dot(b_, b_), before = 0.0;
    report_.residual = longest(b_);
    report_.converged = report_.residual <= limits.force;
    while (!report_.converged && report_.iterations < limits.max_iterations &&
           std::isfinite(squared)) {
        const double ratio = before > 0.0 ? squared / before : 1.0;
        const double loosest = report_.iterations < patience ? first_forcing : late_forcing;
        const double forcing = std::clamp(0.9 * ratio, least_forcing, loosest);
        if (!iterate(system, stage, forcing, x, v)) break;
        before = squared;
        squared = dot(b_, b_);
        report_.residual = longest(b_);
        report_.converged =
            report_.displacement <= limits.tolerance || report_.residual <= limits.force;
    }
    return report_;
}

NewtonReport NewtonSolver::solve_once(ImplicitSystem& system, const ImplicitStage& stage,
                                      Vec3Array<double>& x, Vec3Array<double>& v) {
    report_ = {};
    mixing_.clear();
    evaluate(system, stage, x.view(), v.view());
    report_.residual = longest(b_);
    report_.converged = report_.residual == 0.0;  // as of a cloth that nothing moves
    if (report_.converged) return report_;
    ++report_.iterations;
    system.linearise(stage.t, 1.0 / stage.tau, std::as_const(x).view(), std::as_const(v).view());
    const double slope = find_direction(system, single_forcing);
    const bool moved = move_along(system, stage, slope, x, v);
    report_.residual = longest(b_);
    report_.converged = report_.linear_converged && moved;
    return report_;
}

}  // namespace weft
