// The springs linearised at a state: products with the stiffness and damping matrices. All [slot];
// what is zero in padding stays so.
#pragma once

#include "cloth/cloth_model.h"
#include "math/vec3_array.h"

namespace weft {

/// out = K u, the Hessian of the spring energy at x with its negative part left out:
/// per spring k (n n^T + max(0, 1 - L/l) (I - n n^T)), n = d / l. A compressed spring would push
/// its ends aside (negative stiffness), which does not limit a step.
template <typename Real>
void stiffness_product(const ClothModel& cloth, ConstVec3View<Real> x, ConstVec3View<Real> u,
                       Vec3View<Real> out);

/// out = C u, the dashpots c n n^T of every spring and the drag of every particle.
template <typename Real>
void damping_product(const ClothModel& cloth, const ForcesDescription& forces,
                     ConstVec3View<Real> x, ConstVec3View<Real> u, Vec3View<Real> out);

}  // namespace weft
