// Explicit Runge-Kutta methods: Butcher tables, and one stepper that runs them.
#pragma once

#include <array>
#include <complex>
#include <span>

#include "integrators/integrator.h"
#include "math/instruction_sets.h"

namespace weft {

/// An explicit Runge-Kutta method: stage i is at t + c_i h, from the stages j < i with weights
/// a_ij; the step ends with weights b.
struct ButcherTable {
    static constexpr int max_stages = 7;
    using Weights = std::array<double, max_stages>;
    int stages = 0;
    std::array<Weights, max_stages> a{};
    Weights b{}, c{};
};

extern const ButcherTable forward_euler_table, midpoint_table, kutta3_table, classical4_table;

/// R(z) = 1 + z b^T (I - z A)^-1 1, the growth per step on y' = lambda y with z = h lambda.
std::complex<double> stability_function(const ButcherTable& table, std::complex<double> z);

/// The larger |R| of the two roots of x'' = -omega^2 x - 2 zeta omega x'.
double amplification(const ButcherTable& table, double omega_dt, double zeta);

/// w^T A, which makes slopes of x out of accelerations: with V_i = v + h sum a_ij a_j,
///     sum w_i V_i = (sum w_i) v + h sum (w^T A)_j a_j.
/// What cancels but for rounding is zero.
ButcherTable::Weights position_weights(const ButcherTable& table,
                                       const ButcherTable::Weights& weights);

/// Runs a table on (x, v)' = (v, a(t, x, v)). Since the stage slope of x is the stage's v, only the
/// accelerations a_j are kept:
///     V_i = v + h sum a_ij a_j,     X_i = x + h c_i v + h^2 sum (A^2)_ij a_j,
/// the same method with half the memory.
template <typename Real>
class RungeKutta final : public Integrator<Real> {
public:
    RungeKutta(const ButcherTable& table, InstructionSet instruction_set);
    void prepare(DynamicsSystem<Real>& system) override;
    StepReport step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) override;

private:
    using Weights = ButcherTable::Weights;
    // out_x = x + h c v + h^2 sum xw_j a_j,  out_v = v + h sum vw_j a_j
    void combine(const ParticleState<Real>& state, double h, double c, const Weights& x_weights,
                 const Weights& v_weights, Vec3Array<Real>& out_x, Vec3Array<Real>& out_v) const;

    ButcherTable table_;
    InstructionSet instruction_set_;
    std::array<Weights, ButcherTable::max_stages> a_squared_{};
    Weights b_a_{};  // b^T A
    Vec3Array<Real> stage_x_, stage_v_;
    std::array<Vec3Array<Real>, ButcherTable::max_stages> slopes_;
};

}  // namespace weft
