// What methods that solve for positions share: where a step starts, where inertia leads, and the
// velocity that the solved positions amount to.
#pragma once

#include <vector>

#include "cloth/particle_state.h"
#include "integrators/dynamics_system.h"

namespace weft {

/// A step of implicit Euler, with what is not a spring taken at its start:
///     M (x - y) / h^2 = spring forces at x,     y = x_n + h v_n + h^2 a_ext(t, x_n, v_n),
/// and v = (x - x_n) / h. Gravity is exact; drag and air are explicit (order 1 as the whole).
template <typename Real>
class PositionStep {
public:
    /// @pre the system has a spring network, which outlives this.
    void prepare(DynamicsSystem<Real>& system);

    /// Takes x_n and y; both have the pins of their own time.
    void begin(DynamicsSystem<Real>& system, double dt, const ParticleState<Real>& state);

    /// Ends the step whose positions are in state.x: velocities, time, pins.
    void end(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) const;

    [[nodiscard]] const SpringNetwork& network() const { return *network_; }
    [[nodiscard]] const std::vector<Real>& inverse_masses() const { return inverse_masses_; }
    [[nodiscard]] const Vec3Array<Real>& start() const { return start_; }        ///< x_n [m]
    [[nodiscard]] const Vec3Array<Real>& target() const { return target_; }      ///< y [m]
    [[nodiscard]] const Vec3Array<Real>& external() const { return external_; }  ///< [m/s2]

private:
    const SpringNetwork* network_ = nullptr;
    std::vector<Real> inverse_masses_;  // [slot], 0: pinned, or padding [1/kg]
    Vec3Array<Real> start_, target_, external_, pin_velocities_;
};

extern template class PositionStep<float>;
extern template class PositionStep<double>;

}  // namespace weft
