// What an integrator knows of the system it advances: x' = v, v' = a(t, x, v), and constraints.
#pragma once

#include <cstddef>
#include <span>

#include "cloth/spring_network.h"
#include "math/linear_report.h"
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

/// The system as implicit methods solve with it: in double, whatever the precision of its states.
/// A stage of step tau from (x0, v0) is the root x of
///     M (x - x0 - tau v0) / tau^2 - f(t, x, (x - x0) / tau) = 0
/// among the particles that are not pinned.
class ImplicitSystem {
public:
    virtual ~ImplicitSystem() = default;

    /// As of DynamicsSystem.
    virtual void acceleration(double t, ConstVec3View<double> x, ConstVec3View<double> v,
                              Vec3View<double> a) = 0;
    virtual void constrain(double t, Vec3View<double> x, Vec3View<double> v) const = 0;

    /// [slot], 0: pinned, or padding [1/kg].
    [[nodiscard]] virtual std::span<const double> inverse_masses() const = 0;

    /// Takes the derivative of the stage's left side with respect to x, made symmetric and
    /// positive definite: M / tau^2 - df/dv / tau - df/dx (forces/newton_matrix.h).
    /// x must stay as it is while it is solved with.
    /// @param inverse_tau 1 / tau [1/s].
    virtual void linearise(double t, double inverse_tau, ConstVec3View<double> x,
                           ConstVec3View<double> v) = 0;

    /// d with |r - A d| <= tolerance |r|; d is zero for pinned particles and padding.
    virtual LinearReport solve(ConstVec3View<double> r, double tolerance, Vec3View<double> d) = 0;
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

    /// Takes the state of the steps that follow, where its passes are faster with another order in
    /// memory. Until release() gives it back, constrain() and the passes move what was taken, to
    /// the same bits and whatever arrays they are given; nothing else may be asked for.
    /// @param a what verlet() keeps; without size for kick_drift().
    /// @pre constrain() was called for this time.
    virtual void hold(ConstVec3View<Real> /*x*/, ConstVec3View<Real> /*v*/,
                      ConstVec3View<Real> /*a*/) {}
    virtual void release(Vec3View<Real> /*x*/, Vec3View<Real> /*v*/, Vec3View<Real> /*a*/) {}

    /// For implicit methods, which need it; made at the first call.
    [[nodiscard]] virtual ImplicitSystem* implicit_system() { return nullptr; }

    /// For methods that treat springs one by one, which need both.
    [[nodiscard]] virtual const SpringNetwork* spring_network() { return nullptr; }
    /// What acceleration() gives without springs and their dashpots [m/s2].
    virtual void external_acceleration(double /*t*/, ConstVec3View<Real> /*x*/,
                                       ConstVec3View<Real> /*v*/, Vec3View<Real> a) {
        for (std::size_t s = 0; s < a.size; ++s) a.set(s, {});
    }
};

}  // namespace weft
