// The drawn surface of a welded mesh, and the area around its particles.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "cloth/mesh_topology.h"
#include "weft/frame.h"
#include "weft/scene.h"

namespace weft {

/// The surface: one vertex for every particle and texture co-ordinate that meet in a face, sorted
/// by particle, then by u and v; where every particle has one alone, vertices are particles.
/// Triangles and faces keep the order and the side of `faces`. A mesh without texture co-ordinates
/// gets planar ones over its two largest extents, each from 0 to 1.
Surface build_mesh_surface(const Mesh& mesh, std::span<const ParticleFace> faces,
                           std::span<const Vec3d> positions);

/// The axes that planar texture co-ordinates follow, e.g. "x and y".
std::string_view planar_axes(std::span<const Vec3d> positions);

/// [particle] a third of the area of each triangle around it [m2].
std::vector<double> particle_areas(std::span<const ParticleFace> faces,
                                   std::span<const Vec3d> positions);

}  // namespace weft
