#include "integrators/implicit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace weft {

namespace {

constexpr double root_2 = 1.4142135623730951;
constexpr double gamma_tr_bdf2 = 2.0 - root_2;       // the trapezoidal part of the step
constexpr double gamma_sdirk2 = 1.0 - root_2 / 2.0;  // the L-stable choice

// out = in, in another precision.
template <typename To, typename From>
void convert(const Vec3Array<From>& in, Vec3Array<To>& out) {
    const auto from = in.view();
    const auto to = out.view();
    const auto component = [&](const From* source, To* target) {
        for (std::size_t s = 0; s < from.size; ++s) target[s] = static_cast<To>(source[s]);
    };
    component(from.x, to.x);
    component(from.y, to.y);
    component(from.z, to.z);
}

// out = (4 now - then) / 3
template <typename Real>
void extrapolate(const Vec3Array<Real>& now, const Vec3Array<Real>& then, Vec3Array<double>& out) {
    const auto a = now.view(), b = then.view();
    const auto to = out.view();
    const auto component = [&](const Real* last, const Real* before, double* target) {
        for (std::size_t s = 0; s < to.size; ++s) {
            target[s] = (4.0 * static_cast<double>(last[s]) - static_cast<double>(before[s])) / 3.0;
        }
    };
    component(a.x, b.x, to.x);
    component(a.y, b.y, to.y);
    component(a.z, b.z, to.z);
}

// out = x + h v: where the cloth would go by itself, Newton's first guess. Accelerations are left
// out, in stiff cloth they are of its shortest waves.
void drift(const Vec3Array<double>& x, double h, const Vec3Array<double>& v,
           Vec3Array<double>& out) {
    const double *const from = x.data(), *const by = v.data();
    double* const to = out.data();
    for (std::size_t n = 0; n < out.data_size(); ++n) to[n] = from[n] + h * by[n];
}

// lambda dt of the mode x'' = -w^2 x - 2 zeta w x'.
std::array<std::complex<double>, 2> mode_roots(double omega_dt, double zeta) {
    const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1.0));
    return {omega_dt * (-zeta + root), omega_dt * (-zeta - root)};
}

std::complex<double> growth(const DirkTable& table, std::complex<double> z) {
    std::array<std::complex<double>, DirkTable::max_stages> slopes{};
    std::complex<double> end = 1.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(table.stages); ++i) {
        std::complex<double> y = 1.0;
        for (std::size_t j = 0; j < i; ++j) y += table.a[i][j] * slopes[j];
        slopes[i] = z * y / (1.0 - z * table.a[i][i]);
        end += table.b[i] * slopes[i];
    }
    return end;
}

}  // namespace

const DirkTable implicit_euler_table{1, {{{1.0}}}, {1.0}, {1.0}};
const DirkTable implicit_midpoint_table{1, {{{0.5}}}, {1.0}, {0.5}};
const DirkTable trapezoidal_table{2, {{{0.0}, {0.5, 0.5}}}, {0.5, 0.5}, {0.0, 1.0}};

// Bank et al. (1985) as a Runge-Kutta method: Hosea, Shampine (1996), table 1.
const DirkTable tr_bdf2_table{3,
                              {{{0.0},
                                {gamma_tr_bdf2 / 2.0, gamma_tr_bdf2 / 2.0},
                                {root_2 / 4.0, root_2 / 4.0, gamma_tr_bdf2 / 2.0}}},
                              {root_2 / 4.0, root_2 / 4.0, gamma_tr_bdf2 / 2.0},
                              {0.0, gamma_tr_bdf2, 1.0}};

// Alexander (1977), section 3.
const DirkTable sdirk2_table{2,
                             {{{gamma_sdirk2}, {1.0 - gamma_sdirk2, gamma_sdirk2}}},
                             {1.0 - gamma_sdirk2, gamma_sdirk2},
                             {gamma_sdirk2, 1.0}};

double dirk_amplification(const DirkTable& table, double omega_dt, double zeta) {
    const auto roots = mode_roots(omega_dt, zeta);
    return std::max(std::abs(growth(table, roots[0])), std::abs(growth(table, roots[1])));
}

double bdf2_amplification(double omega_dt, double zeta) {
    double largest = 0.0;
    for (const std::complex<double> z : mode_roots(omega_dt, zeta)) {
        // (1 - 2/3 z) r^2 - 4/3 r + 1/3 = 0
        const std::complex<double> a = 1.0 - 2.0 / 3.0 * z;
        const std::complex<double> root = std::sqrt(4.0 / 9.0 - a / 3.0);
        largest =
            std::max({largest, std::abs((2.0 / 3.0 + root) / a), std::abs((2.0 / 3.0 - root) / a)});
    }
    return largest;
}

std::optional<StepFailure> StageSolver::solve(ImplicitSystem& system, const ImplicitStage& stage,
                                              Vec3Array<double>& x, Vec3Array<double>& v) {
    const NewtonReport report = single_solve_ ? newton_.solve_once(system, stage, x, v)
                                              : newton_.solve(system, stage, limits_, x, v);
    counts_.evaluations += static_cast<std::size_t>(report.evaluations);
    counts_.newton_iterations += static_cast<std::size_t>(report.iterations);
    counts_.linear_iterations += static_cast<std::size_t>(report.linear_iterations);
    if (report.converged) return std::nullopt;
    return failure(stage, report);
}

StepFailure StageSolver::failure(const ImplicitStage& stage, const NewtonReport& report) const {
    if (!std::isfinite(report.residual)) {
        return {fmt::format("forces are not finite at {:.6g} s, in Newton's iteration {}", stage.t,
                            report.iterations),
                "try a smaller integrator.time_step"};
    }
    if (!report.linear_converged) {
        return {fmt::format("the linear solver did not converge at {:.6g} s: relative residual "
                            "{:.2g} after {} iterations in Newton's iteration {}",
                            stage.t, report.linear_residual, report.linear_iterations,
                            report.iterations),
                "try integrator.linear_solver = \"cholesky\", or a smaller integrator.time_step"};
    }
    return {fmt::format("Newton did not converge at {:.6g} s: after {} iterations particles still "
                        "move {:.2g} m, unbalanced force {:.2g} N (tolerance {:.2g} m)",
                        stage.t, report.iterations, report.displacement, report.residual,
                        limits_.tolerance),
            "try a smaller integrator.time_step, a larger integrator.tolerance or more "
            "integrator.iterations"};
}

template <typename Real>
DiagonallyImplicit<Real>::DiagonallyImplicit(const DirkTable& table, const NewtonLimits& limits,
                                             bool single_solve)
    : table_(table), solver_(limits, single_solve) {}

template <typename Real>
void DiagonallyImplicit<Real>::prepare(DynamicsSystem<Real>& system) {
    const std::size_t slots = system.slot_count();
    solver_.prepare(slots);
    x_ = v_ = x0_ = v0_ = stage_x_ = Vec3Array<double>(slots);
    for (std::size_t i = 0; i < static_cast<std::size_t>(table_.stages); ++i) {
        velocities_[i] = accelerations_[i] = Vec3Array<double>(slots);
    }
    (void)system.implicit_system();  // made here rather than in the first step
}

template <typename Real>
void DiagonallyImplicit<Real>::combine(double h, const Weights& weights, std::size_t count,
                                       Vec3Array<double>& out_x, Vec3Array<double>& out_v) const {
    const auto add = [&](const auto& slopes, const Vec3Array<double>& start,
                         Vec3Array<double>& out) {
        out = start;
        for (std::size_t j = 0; j < count; ++j) {
            if (weights[j] == 0.0) continue;
            const double factor = h * weights[j];
            const double* const slope = slopes[j].data();
            for (std::size_t n = 0; n < out.data_size(); ++n) out.data()[n] += factor * slope[n];
        }
    };
    add(velocities_, x_, out_x);
    add(accelerations_, v_, out_v);
}

template <typename Real>
StepReport DiagonallyImplicit<Real>::step(DynamicsSystem<Real>& system, double dt,
                                          ParticleState<Real>& state) {
    ImplicitSystem& implicit = *system.implicit_system();
    const auto stages = static_cast<std::size_t>(table_.stages);
    convert(state.x, x_);
    convert(state.v, v_);
    for (std::size_t i = 0; i < stages; ++i) {
        const double t = state.time + table_.c[i] * dt, gamma = table_.a[i][i];
        combine(dt, table_.a[i], i, x0_, v0_);
        if (gamma == 0.0) {
            velocities_[i] = v0_;
            implicit.acceleration(t, x0_.view(), v0_.view(), accelerations_[i].view());
            solver_.count_evaluation();
            continue;
        }
        const ImplicitStage stage{t, gamma * dt, std::as_const(x0_).view(),
                                  std::as_const(v0_).view()};
        drift(x_, table_.c[i] * dt, v_, stage_x_);
        if (auto failure = solver_.solve(implicit, stage, stage_x_, velocities_[i])) {
            return {std::move(failure)};
        }
        const double per_tau = 1.0 / stage.tau;
        double* const slope = accelerations_[i].data();
        const double *const end = velocities_[i].data(), *const start = v0_.data();
        for (std::size_t n = 0; n < v0_.data_size(); ++n) slope[n] = per_tau * (end[n] - start[n]);
    }
    combine(dt, table_.b, stages, x0_, v0_);
    convert(x0_, state.x);
    convert(v0_, state.v);
    state.time += dt;
    system.constrain(state.time, state.x.view(), state.v.view());
    return {};
}

template <typename Real>
Bdf2<Real>::Bdf2(const NewtonLimits& limits) : starter_(sdirk2_table, limits), solver_(limits) {}

template <typename Real>
void Bdf2<Real>::prepare(DynamicsSystem<Real>& system) {
    const std::size_t slots = system.slot_count();
    starter_.prepare(system);
    solver_.prepare(slots);
    x_before_ = v_before_ = Vec3Array<Real>(slots);
    x0_ = v0_ = x_ = v_ = Vec3Array<double>(slots);
}

template <typename Real>
StepReport Bdf2<Real>::step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) {
    if (last_step_ != dt) {
        x_before_ = state.x;
        v_before_ = state.v;
        StepReport report = starter_.step(system, dt, state);
        last_step_ = report.ok() ? dt : 0.0;
        return report;
    }
    extrapolate(state.x, x_before_, x0_);
    extrapolate(state.v, v_before_, v0_);
    const ImplicitStage stage{state.time + dt, 2.0 / 3.0 * dt, std::as_const(x0_).view(),
                              std::as_const(v0_).view()};
    convert(state.x, x_);
    convert(state.v, v_);
    drift(x_, dt, v_, x_);
    if (auto failure = solver_.solve(*system.implicit_system(), stage, x_, v_)) {
        return {std::move(failure)};
    }
    std::swap(x_before_, state.x);
    std::swap(v_before_, state.v);
    convert(x_, state.x);
    convert(v_, state.v);
    state.time += dt;
    system.constrain(state.time, state.x.view(), state.v.view());
    return {};
}

template <typename Real>
void Bdf2<Real>::save(History& history) const {
    history.arrays = {x_before_, v_before_};
    history.last_step = last_step_;
}

template <typename Real>
void Bdf2<Real>::restore(const History& history) {
    last_step_ = history.last_step;
    if (history.arrays.size() != 2) return;
    x_before_ = history.arrays[0];
    v_before_ = history.arrays[1];
}

template <typename Real>
SolverCounts Bdf2<Real>::counts() const {
    return solver_.counts() + starter_.counts();
}

template class DiagonallyImplicit<float>;
template class DiagonallyImplicit<double>;
template class Bdf2<float>;
template class Bdf2<double>;

}  // namespace weft
