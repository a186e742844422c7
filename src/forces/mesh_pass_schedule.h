// In what order the parts of a mesh's pass run, and how far apart what they hand on may stand.
#pragma once

#include <cstddef>
#include <vector>

#include "forces/mesh_pass_tables.h"

namespace weft {

/// How far each part of a pass has come when a chunk of it ends.
struct MeshChunk {
    std::size_t slices_copied = 0;
    std::size_t triangle_vectors = 0;
    std::size_t slices_moved = 0;
};

/// A pass runs chunk after chunk: copies the slices that the chunk's sums and triangles read, then
/// finds its triangles' forces, then sums and moves its slices.
struct MeshSchedule {
    std::vector<MeshChunk> chunks;
    std::size_t rows = 0, thirds = 0;  ///< that a pass needs at once; powers of two, or 0

    MeshSchedule() = default;
    /// @param neighbours, triangles as built: slots, and numbers of triangles.
    /// @param slices of the mesh, and in a chunk.
    MeshSchedule(const SlicedLists& neighbours, const MeshTriangleTables& triangles,
                 std::size_t slices, std::size_t slices_per_chunk, std::size_t lanes);
};

}  // namespace weft
