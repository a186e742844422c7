// Vertices in the same place become one particle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "weft/scene.h"

namespace weft {

/// Which particle each vertex of a mesh is.
struct MeshWeld {
    static constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::uint32_t> vertex_particle;  ///< [vertex]; `unused` for a vertex in no face
    std::vector<std::uint32_t> first_vertex;     ///< [particle] the vertex that gives its place
    std::size_t welded_vertices = 0;             ///< in a face, and at the place of an earlier one
    std::size_t unused_vertices = 0;
};

/// Two vertices are in the same place within 1e-6 of the diagonal of the box around the faces. Each
/// vertex joins the earliest particle within that distance of it, else it is a new particle, so
/// that particles stand in the order of their first vertices.
/// @param mesh passes check_mesh().
MeshWeld weld_vertices(const Mesh& mesh);

}  // namespace weft
