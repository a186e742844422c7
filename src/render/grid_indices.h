// Drawing a grid with fewer triangles.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "weft/frame.h"

namespace weft {

/// Vertices of a surface that is a grid, row after row.
struct SurfaceGrid {
    std::uint32_t columns = 0, rows = 0;
};

/// @return nothing for a surface that is no plain grid of quads, as that of a mesh.
std::optional<SurfaceGrid> grid_of(const Surface& surface);

/// Triangles between every `step`-th row and column, and the last ones; in the order of corners of
/// the surface's own. All triangles where the surface is no grid.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const Surface& surface, std::uint32_t step);

}  // namespace weft
