// Energy by kind, rates of work, and strain, all in double and in one order of summation: that of
// the particles' numbers, wherever they stand. x and v: [slot].
#pragma once

#include "cloth/cloth_model.h"
#include "math/vec3_array.h"
#include "weft/measures.h"

namespace weft {

/// Energies of the state: kinetic, gravity -sum m g.x, springs k (l - L)^2 / 2 by kind.
template <typename Real>
Energy energy(const ClothModel& cloth, const ForcesDescription& forces, ConstVec3View<Real> x,
              ConstVec3View<Real> v);

/// Rate of work of the dashpots, -sum c rate^2 [W].
template <typename Real>
double dashpot_power(const ClothModel& cloth, ConstVec3View<Real> x, ConstVec3View<Real> v);

/// Rate of work of the drag on particles, -sum c |v|^2 [W].
template <typename Real>
double drag_power(const ClothModel& cloth, const ForcesDescription& forces, ConstVec3View<Real> v);

/// The spring whose length differs most from its rest length, relative to it.
template <typename Real>
SpringStrain largest_strain(const ClothModel& cloth, ConstVec3View<Real> x);

}  // namespace weft
