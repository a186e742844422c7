// What an integrator knows of the system it advances: x' = v, v' = a(t, x, v), and constraints.
#pragma once

#include <cstddef>

#include "math/vec3_array.h"

namespace weft {

/// A sweep over memory that computes the acceleration and at once moves what it moves.
template <typename Real>
class KickDriftPass {
public:
    virtual ~KickDriftPass() = default;

    /// v += kick a(t, x, v), then x += drift v; constrain() remains to be called.
    virtual void kick_drift(double t, double kick, double drift, Vec3View<Real> x,
                            Vec3View<Real> v) = 0;
};

/// The like for a whole step of velocity Verlet (verlet.h).
template <typename Real>
class VerletPass {
public:
    virtual ~VerletPass() = default;

    /// From t to t + h, pins included.
    /// @pre pinned particles are where constrain() puts them at t.
    /// @param a the acceleration at t; becomes that at t + h.
    virtual void verlet(double t, double h, Vec3View<Real> x, Vec3View<Real> v,
                        Vec3View<Real> a) = 0;
};

template <typename Real>
class DynamicsSystem {
public:
    virtual ~DynamicsSystem() = default;

    /// Size of a state's arrays.
    [[nodiscard]] virtual std::size_t slot_count() const = 0;

    /// a = M^-1 f(t, x, v) [m/s2], zero for pinned particles.
    virtual void acceleration(double t, ConstVec3View<Real> x, ConstVec3View<Real> v,
                              Vec3View<Real> a) = 0;

    /// Puts pinned particles where they are at time t, with the velocity they have then.
    virtual void constrain(double t, Vec3View<Real> x, Vec3View<Real> v) const = 0;

    /// The system's own passes, where it has such; the same for as long as it lives.
    [[nodiscard]] virtual KickDriftPass<Real>* kick_drift_pass() { return nullptr; }
    [[nodiscard]] virtual VerletPass<Real>* verlet_pass() { return nullptr; }
};

}  // namespace weft
