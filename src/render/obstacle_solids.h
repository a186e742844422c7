// Obstacles as solids to draw.
#pragma once

#include <optional>

#include "render/solid.h"
#include "render/stage.h"

namespace weft {

/// Balls, and plates in place of planes: each a square around the stage, with tiles to see its
/// slope by. A plane that is the floor is left out, for the ground is drawn as such.
/// @param fine as recordings want it; else with fewer triangles.
Solid build_obstacles(const Stage& stage, bool fine);

/// What they span; none where there is nothing.
std::optional<Box> bounds_of(const Solid& solid);

}  // namespace weft
