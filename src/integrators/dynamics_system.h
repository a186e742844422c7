// What an integrator knows of the system it advances: x' = v, v' = a(t, x, v), and constraints.
#pragma once

#include <cstddef>

#include "math/vec3_array.h"

namespace weft {

template <typename Real>
class DynamicsSystem {
public:
    virtual ~DynamicsSystem() = default;

    [[nodiscard]] virtual std::size_t particle_count() const = 0;

    /// a = M^-1 f(t, x, v) [m/s2], zero for pinned particles.
    virtual void acceleration(double t, ConstVec3View<Real> x, ConstVec3View<Real> v,
                              Vec3View<Real> a) = 0;

    /// Puts pinned particles where they are at time t, with the velocity they have then.
    virtual void constrain(double t, Vec3View<Real> x, Vec3View<Real> v) const = 0;
};

}  // namespace weft
