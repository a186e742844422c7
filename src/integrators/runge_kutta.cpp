#include "integrators/runge_kutta.h"

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

template <typename Real>
RungeKutta<Real>::RungeKutta(const ButcherTable& table, InstructionSet instruction_set)
    : table_(table), instruction_set_(instruction_set) {
    const auto stages = static_cast<std::size_t>(table_.stages);
    for (std::size_t i = 0; i < stages; ++i) {
        for (std::size_t j = 0; j < stages; ++j) {
            for (std::size_t k = 0; k < stages; ++k) {
                a_squared_[i][j] += table_.a[i][k] * table_.a[k][j];
            }
            b_a_[j] += table_.b[i] * table_.a[i][j];
        }
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
void RungeKutta<Real>::step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) {
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
}

template class RungeKutta<float>;
template class RungeKutta<double>;

}  // namespace weft
