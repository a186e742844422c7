// The springs of a welded mesh.
#pragma once

#include <span>
#include <vector>

#include "cloth/mesh_topology.h"
#include "cloth/springs.h"

namespace weft {

/// Structural springs along every edge, shear springs across every quad, bend springs across every
/// edge of two faces, in this order; within a kind sorted by (p, q). With w(f) the area of a
/// triangle and half the area of a quad, the strip that a spring stands for has the area
///     structural: the sum of w over the faces of the edge
///     bend:       (w(f1) + w(f2)) / number of pairs that the edge gives, summed over edges
/// and the width factor is that area over the rest length squared; a shear spring has
/// L^2 / (2 quad area), summed over quads. On a regular grid these are the factors of the grid.
/// @param areas [face] [m2]; a face whose area is 0 adds nothing to a width factor.
std::vector<Spring> build_mesh_springs(std::span<const ParticleFace> faces,
                                       std::span<const double> areas, const EdgeTable& table,
                                       std::span<const Vec3d> positions);

}  // namespace weft
