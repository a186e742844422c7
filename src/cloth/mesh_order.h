// The order in which a mesh's particles stand in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/springs.h"

namespace weft {

/// Slots that bring the two ends of every spring near each other, by reverse Cuthill-McKee (Cuthill
/// and McKee 1969, George 1971): breadth-first from a particle at the edge of the cloth, those with
/// few springs before those with many, then turned round. No particle is farther from its
/// neighbours than about two rings of the search are wide: of n x n particles in any order, 2 n.
/// Among equals the lower number is first; pieces that no spring joins stand one after the other.
/// @return [particle], for ParticleLayout::of_slots().
std::vector<std::uint32_t> mesh_order(std::size_t particle_count, std::span<const Spring> springs);

}  // namespace weft
