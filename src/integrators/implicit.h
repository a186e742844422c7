// Implicit methods: diagonally implicit Runge-Kutta tables and BDF2, over one Newton solver.
#pragma once

#include <array>
#include <optional>

#include "integrators/integrator.h"
#include "integrators/newton.h"

namespace weft {

/// A diagonally implicit Runge-Kutta method: stage i is at t + c_i h, from stages j <= i with
/// weights a_ij; where a_ii = 0 it is explicit. The step ends with weights b.
struct DirkTable {
    static constexpr int max_stages = 3;
    int stages = 0;
    std::array<std::array<double, max_stages>, max_stages> a{};
    std::array<double, max_stages> b{}, c{};
};

extern const DirkTable implicit_euler_table, implicit_midpoint_table, trapezoidal_table,
    tr_bdf2_table, sdirk2_table;

/// Spectral radius of one step on x'' = -w^2 x - 2 zeta w x', with w = omega * dt.
double dirk_amplification(const DirkTable& table, double omega_dt, double zeta);
double bdf2_amplification(double omega_dt, double zeta);

/// Solves the stages of a step: Newton, what it cost, and what to say when it fails.
class StageSolver {
public:
    explicit StageSolver(const NewtonLimits& limits, bool single_solve = false)
        : limits_(limits), single_solve_(single_solve) {}

    void prepare(std::size_t slots) { newton_.prepare(slots); }

    /// As NewtonSolver::solve.
    std::optional<StepFailure> solve(ImplicitSystem& system, const ImplicitStage& stage,
                                     Vec3Array<double>& x, Vec3Array<double>& v);

    void count_evaluation() { ++counts_.evaluations; }
    [[nodiscard]] const SolverCounts& counts() const { return counts_; }

private:
    [[nodiscard]] StepFailure failure(const ImplicitStage& stage, const NewtonReport& report) const;

    NewtonLimits limits_;
    bool single_solve_;
    NewtonSolver newton_;
    SolverCounts counts_;
};

/// Runs a table on (x, v)' = (v, a(t, x, v)). Stage i is the stage of step a_ii h (newton.h) from
///     x0 = x + h sum_j<i a_ij V_j,    v0 = v + h sum_j<i a_ij A_j,
/// and gives the slopes V_i = v_i, A_i = (v_i - v0) / (a_ii h). In double whatever the state's
/// precision, which the end of the step is rounded to.
template <typename Real>
class DiagonallyImplicit final : public Integrator<Real> {
public:
    /// @param single_solve one linear solve a stage instead of Newton's iterations.
    DiagonallyImplicit(const DirkTable& table, const NewtonLimits& limits,
                       bool single_solve = false);
    void prepare(DynamicsSystem<Real>& system) override;
    StepReport step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) override;
    [[nodiscard]] SolverCounts counts() const override { return solver_.counts(); }

private:
    using Weights = std::array<double, DirkTable::max_stages>;
    // out_x = x + h sum_j<count weights_j V_j, and out_v of the A_j alike.
    void combine(double h, const Weights& weights, std::size_t count, Vec3Array<double>& out_x,
                 Vec3Array<double>& out_v) const;

    DirkTable table_;
    StageSolver solver_;
    Vec3Array<double> x_, v_;              // at the step's start
    Vec3Array<double> x0_, v0_, stage_x_;  // of a stage
    std::array<Vec3Array<double>, DirkTable::max_stages> velocities_, accelerations_;
};

/// The two-step backward differentiation formula (Curtiss, Hirschfelder 1952),
///     x+ = (4 x - x_prev) / 3 + 2/3 h v+,   v+ = (4 v - v_prev) / 3 + 2/3 h a+,
/// for steps of one length. The first, and the first of another length, is one of sdirk2.
template <typename Real>
class Bdf2 final : public Integrator<Real> {
public:
    explicit Bdf2(const NewtonLimits& limits);
    void prepare(DynamicsSystem<Real>& system) override;
    StepReport step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) override;
    void restart() override { last_step_ = 0.0; }
    using typename Integrator<Real>::History;
    void save(History& history) const override;
    void restore(const History& history) override;
    [[nodiscard]] SolverCounts counts() const override;

private:
    DiagonallyImplicit<Real> starter_;
    StageSolver solver_;
    Vec3Array<Real> x_before_, v_before_;  // a step ago
    double last_step_ = 0.0;               // [s]; 0: none yet
    Vec3Array<double> x0_, v0_, x_, v_;
};

}  // namespace weft
