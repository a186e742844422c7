// Springs between particles and points of space: how a hand holds the cloth.
#pragma once

#include <cstddef>
#include <vector>

#include "cloth/particle_state.h"
#include "weft/vec3.h"

namespace weft {

/// All that pulls at one particle: f = pull - stiffness x - damping v.
struct GripSpring {
    std::size_t slot = 0;
    double mass = 0.0;       ///< of the particle [kg]
    double stiffness = 0.0;  ///< k, of all together [N/m]
    double damping = 0.0;    ///< c, likewise [N s/m]
    Vec3d pull{};            ///< sum of k p over the points p [N]
    Vec3d start{};           ///< where the particle was as the step began [m]
    Vec3d velocity{};        ///< that the damper feels: of the way in the last step [m/s]

    [[nodiscard]] Vec3d force(Vec3d x, Vec3d v) const { return pull - stiffness * x - damping * v; }
};

/// Each particle once, none of them pinned.
using GripSprings = std::vector<GripSpring>;

template <typename Real>
void begin_grips(GripSprings& grips, ConstVec3View<Real> x) {
    for (GripSpring& grip : grips) grip.start = vec3_cast<double>(x[grip.slot]);
}

/// What the springs do to a step of h that knew nothing of them: backward Euler of each on its own,
///     m dv = h f(x + h dv, (x + h dv - start) / h),    v += dv,    x += h dv,
/// stable for any k, c and h. A particle that hangs still hangs where k bears its weight, whatever
/// the method. The damper takes the way, not the velocity at the end: at long steps of an explicit
/// method they have little to do with each other, and a place corrected by v is driven about.
/// @pre begin_grips() as the step began.
template <typename Real>
void pull_grips(GripSprings& grips, double h, Vec3View<Real> x, Vec3View<Real> v);

extern template void pull_grips(GripSprings&, double, Vec3View<float>, Vec3View<float>);
extern template void pull_grips(GripSprings&, double, Vec3View<double>, Vec3View<double>);

}  // namespace weft
