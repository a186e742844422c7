#include "integrators/runge_kutta.h"

#include <algorithm>
#include <cmath>

#include "math/linear_combination.h"

namespace weft {

const ButcherTable forward_euler_table{1, {}, {1.0}, {0.0}};

const ButcherTable midpoint_table{2, {{{0.0}, {0.5}}}, {0.0, 1.0}, {0.0, 0.5}};

// The comparison's eq. 12, with its misprint mended: K2 = f(x + h/2, y + h/2 K1), not K2.
const ButcherTable kutta3_table{
    3, {{{0.0}, {0.5}, {-1.0, 2.0}}}, {1.0 / 6, 4.0 / 6, 1.0 / 6}, {0.0, 0.5, 1.0}};

const ButcherTable classical4_table{4,
                                    {{{0.0}, {0.5}, {0.0, 0.5}, {0.0, 0.0, 1.0}}},
                                    {1.0 / 6, 2.0 / 6, 2.0 / 6, 1.0 / 6},
                                    {0.0, 0.5, 0.5, 1.0}};

std::complex<double> stability_function(const ButcherTable& table, std::complex<double> z) {
    std::array<std::complex<double>, ButcherTable::max_stages> slopes{};
    std::complex<double> end = 1.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(table.stages); ++i) {
        std::complex<double> y = 1.0;
        for (std::size_t j = 0; j < i; ++j) y += table.a[i][j] * slopes[j];
        slopes[i] = z * y;
        end += table.b[i] * slopes[i];
    }
    return end;
}

double amplification(const ButcherTable& table, double omega_dt, double zeta) {
    const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1.0));
    return std::max(std::abs(stability_function(table, omega_dt * (-zeta + root))),
                    std::abs(stability_function(table, omega_dt * (-zeta - root))));
}

ButcherTable::Weights position_weights(const ButcherTable& table,
                                       const ButcherTable::Weights& weights) {
    constexpr double rounding = 1e-14;  // of a sum, as a part of its terms
    const auto stages = static_cast<std::size_t>(table.stages);
    ButcherTable::Weights sums{};
    for (std::size_t j = 0; j < stages; ++j) {
        double size = 0.0;
        for (std::size_t i = 0; i < stages; ++i) {
            sums[j] += weights[i] * table.a[i][j];
            size += std::abs(weights[i] * table.a[i][j]);
        }
        if (std::abs(sums[j]) < rounding * size) sums[j] = 0.0;
    }
    return sums;
}

template <typename Real>
RungeKutta<Real>::RungeKutta(const ButcherTable& table, InstructionSet instruction_set)
    : table_(table), instruction_set_(instruction_set), b_a_(position_weights(table, table.b)) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(table_.stages); ++i) {
        a_squared_[i] = position_weights(table_, table_.a[i]);
    }
}

template <typename Real>
void RungeKutta<Real>::prepare(DynamicsSystem<Real>& system) {
    if (table_.stages > 1) {
        stage_x_ = Vec3Array<Real>(system.slot_count());
        stage_v_ = Vec3Array<Real>(system.slot_count());
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(table_.stages); ++i) {
        slopes_[i] = Vec3Array<Real>(system.slot_count());
    }
}

template <typename Real>
void RungeKutta<Real>::combine(const ParticleState<Real>& state, double h, double c,
                               const Weights& x_weights, const Weights& v_weights,
                               Vec3Array<Real>& out_x, Vec3Array<Real>& out_v) const {
    LinearCombination<Real> sums(out_x, out_v);
    sums.add(state.x, 1.0).add(state.v, h * c, 1.0);
    for (std::size_t j = 0; j < static_cast<std::size_t>(table_.stages); ++j) {
        sums.add(slopes_[j], h * h * x_weights[j], h * v_weights[j]);
    }
    sums.compute(instruction_set_);
}

template <typename Real>
StepReport RungeKutta<Real>::step(DynamicsSystem<Real>& system, double dt,
                                  ParticleState<Real>& state) {
    system.acceleration(state.time, state.x.view(), state.v.view(), slopes_[0].view());
    for (std::size_t i = 1; i < static_cast<std::size_t>(table_.stages); ++i) {
        const double t = state.time + table_.c[i] * dt;
        combine(state, dt, table_.c[i], a_squared_[i], table_.a[i], stage_x_, stage_v_);
        system.constrain(t, stage_x_.view(), stage_v_.view());
        system.acceleration(t, stage_x_.view(), stage_v_.view(), slopes_[i].view());
    }
    combine(state, dt, 1.0, b_a_, table_.b, state.x, state.v);
    state.time += dt;
    system.constrain(state.time, state.x.view(), state.v.view());
    return {};
}

template class RungeKutta<float>;
template class RungeKutta<double>;

}  // namespace weft
