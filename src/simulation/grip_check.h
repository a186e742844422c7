// Grips as a user gives them, made into springs of particles.
#pragma once

#include <span>

#include "cloth/cloth_model.h"
#include "contact/grip_springs.h"
#include "weft/simulation.h"

namespace weft {

/// @throws Error (usage) for a particle that does not exist, a number that is not finite, or a
///         negative stiffness or damping.
void check_grips(std::span<const Grip> grips, std::size_t particle_count);

/// Those of one particle together, by rising slot; none of pinned particles.
GripSprings grip_springs(std::span<const Grip> grips, const ClothModel& cloth);

}  // namespace weft
