// Which particles are pinned, and how they move.
#pragma once

#include "cloth/cloth_model.h"

namespace weft {

/// Fills in `pins` and `motions` from the scene's selectors.
/// @throws Error (usage) where a selector picks nothing, names a particle that does not exist, or
///         gives a particle a second, different motion.
void place_pins(const SceneDescription& scene, ClothModel& cloth);

}  // namespace weft
