// The mast of a flag: where it stands, and its solid.
#pragma once

#include <span>

#include "render/solid.h"
#include "render/stage.h"

namespace weft {

/// The pole along a cloth's edge: from the ground to a little above the cloth where the edge is
/// upright, else along the edge and a little beyond both ends.
/// @param edge points of the edge, one at least [m]; @param cloth of the first frame;
/// @param ground height of the floor [m].
Pole plan_mast(std::span<const glm::vec3> edge, const Box& cloth, float ground);

/// The pole with its finials and the rings that hold the cloth.
/// @param fine as recordings want it; else with a third of the triangles.
Solid build_mast(const Pole& pole, bool fine = true);

}  // namespace weft
