// What a step changes: positions, velocities, time. Slots are those of ClothModel::layout.
#pragma once

#include "math/vec3_array.h"

namespace weft {

template <typename Real>
struct ParticleState {
    Vec3Array<Real> x;  ///< [slot], [m]
    Vec3Array<Real> v;  ///< [slot], [m/s]
    double time = 0.0;  ///< [s]
};

}  // namespace weft
