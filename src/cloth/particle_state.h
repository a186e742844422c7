// What a step changes: positions, velocities, time.
#pragma once

#include "math/vec3_array.h"

namespace weft {

template <typename Real>
struct ParticleState {
    Vec3Array<Real> x;  ///< [particle], [m]
    Vec3Array<Real> v;  ///< [particle], [m/s]
    double time = 0.0;  ///< [s]
};

}  // namespace weft
