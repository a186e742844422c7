// The Verlet family: position Verlet with fixed and with changing step, and velocity Verlet.
#pragma once

#include "integrators/integrator.h"

namespace weft {

/// Position Verlet with the step's change taken into account ("time-corrected"),
///     x+ = x + (x - x_prev) dt/dt_prev + a dt (dt + dt_prev)/2,
/// which at a fixed step is x+ = x + (x - x_prev) + a dt^2 (the first paper prints P_i + P_(i-1),
/// the comparison's eq. 3 and 4 print a dt^3/2; both are misprints).
///
/// It needs no velocity to move (the comparison says otherwise). The velocity it puts out is the
/// central difference (comparison eq. 6), v = (x_next - x_prev) / (2 dt), which the next
/// acceleration makes known at once: v = (x - x_prev)/dt + a dt/2. Forces that depend on velocity
/// take the one-sided difference of second order, v = (3 x - 4 x_prev + x_prevprev) / (2 dt).
/// The first step takes x_prev = x0 - dt v0 + dt^2 a0/2 (with a given step both ways).
template <typename Real>
class PositionVerlet final : public Integrator<Real> {
public:
    using History = typename Integrator<Real>::History;

    /// @param time_corrected false: a change of step starts the method anew from x and v.
    explicit PositionVerlet(bool time_corrected) : time_corrected_(time_corrected) {}
    void prepare(DynamicsSystem<Real>& system) override;
    StepReport step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) override;
    void restart() override { last_step_ = 0.0; }
    void save(History& history) const override {
        history.arrays.resize(2);  // copied into the same memory frame after frame
        history.arrays[0] = x_previous_;
        history.arrays[1] = a_;
        history.last_step = last_step_;
    }
    void restore(const History& history) override;

private:
    void start(DynamicsSystem<Real>& system, double dt, const ParticleState<Real>& state);

    bool time_corrected_;
    double last_step_ = 0.0;  // [s]; 0: no step made yet
    Vec3Array<Real> x_previous_, a_;
};

/// Velocity Verlet: x+ = x + dt v + dt^2 a/2, v+ = v + dt (a + a+)/2. Forces that depend on
/// velocity take v + dt a in a+, which keeps order 2 with one evaluation a step; the next step uses
/// this a+.
template <typename Real>
class VelocityVerlet final : public Integrator<Real> {
public:
    using History = typename Integrator<Real>::History;

    void prepare(DynamicsSystem<Real>& system) override;
    StepReport step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) override;
    void begin(DynamicsSystem<Real>& system, const ParticleState<Real>& state) override;
    void finish(DynamicsSystem<Real>& system, ParticleState<Real>& state) override;
    void restart() override { started_ = false; }
    void save(History& history) const override {
        history.arrays.resize(1);
        history.arrays[0] = a_;
        history.last_step = started_ ? 1.0 : 0.0;
    }
    void restore(const History& history) override;

private:
    void start(DynamicsSystem<Real>& system, const ParticleState<Real>& state);

    bool started_ = false;
    Vec3Array<Real> a_, a_next_;  // a_next_: where the system has no pass of its own
};

/// Spectral radii of one step on x'' = -w^2 x - 2 zeta w x', with w = omega * dt.
double position_verlet_amplification(double omega_dt, double zeta);
double velocity_verlet_amplification(double omega_dt, double zeta);

}  // namespace weft
