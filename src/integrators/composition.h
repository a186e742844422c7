// Symplectic compositions: tables of kicks v += b h a(x, v) and drifts x += a h v, and one stepper
// that runs them.
#pragma once

#include <array>

#include "integrators/integrator.h"

namespace weft {

struct Stage {
    double drift = 0.0;  ///< fraction of h, before the kick
    double kick = 0.0;   ///< fraction of h
};

/// Stages in order, then a last drift.
struct CompositionTable {
    static constexpr int max_stages = 3;
    int stages = 0;
    std::array<Stage, max_stages> stage{};
    double last_drift = 0.0;
};

extern const CompositionTable symplectic_euler_table, fourth_order_table;

/// Spectral radius of one step on x'' = -w^2 x - 2 zeta w x', with w = omega * dt.
double composition_amplification(const CompositionTable& table, double omega_dt, double zeta);

/// Forces that depend on velocity are evaluated with the velocity before the kick, which makes the
/// method's order 1 in the damping.
template <typename Real>
class Composition final : public Integrator<Real> {
public:
    explicit Composition(const CompositionTable& table) : table_(table) {}
    void prepare(DynamicsSystem<Real>& system) override;
    StepReport step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) override;
    void begin(DynamicsSystem<Real>& system, const ParticleState<Real>& state) override;
    void finish(DynamicsSystem<Real>& system, ParticleState<Real>& state) override;

private:
    void drift(double h, ParticleState<Real>& state) const;
    void kick(DynamicsSystem<Real>& system, double t, double h, ParticleState<Real>& state);

    CompositionTable table_;
    Vec3Array<Real> a_;  // where the system has no pass of its own
};

}  // namespace weft
