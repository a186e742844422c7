// Finding a grid in a surface, and thinning it.
#include "render/grid_indices.h"

#include <algorithm>

namespace weft {

std::optional<SurfaceGrid> grid_of(const Surface& surface) {
    if (surface.faces.empty() || !surface.vertex_particle.empty()) return std::nullopt;
    const auto& first = surface.faces.front();
    if (first[3] == Surface::no_vertex) return std::nullopt;
    const std::uint32_t columns = *std::max_element(first.begin(), first.end()) - 1;
    const std::size_t vertices = surface.vertex_count();
    if (columns < 2 || vertices % columns != 0) return std::nullopt;
    const auto rows = static_cast<std::uint32_t>(vertices / columns);
    if (rows < 2 || surface.faces.size() != std::size_t{columns - 1} * (rows - 1) ||
        surface.triangles.size() != 2 * surface.faces.size())
        return std::nullopt;
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
        const std::uint32_t shift = face / (columns - 1) * columns + face % (columns - 1);
        for (std::size_t corner = 0; corner < 4; ++corner)
            if (surface.faces[face][corner] != first[corner] + shift) return std::nullopt;
    }
    return SurfaceGrid{columns, rows};
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Surface& surface, std::uint32_t step) {
    const auto grid = step > 1 ? grid_of(surface) : std::nullopt;
    if (!grid) return surface.triangles;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t row = 0; row + 1 < grid->rows; row += step)
        for (std::uint32_t column = 0; column + 1 < grid->columns; column += step) {
            const std::uint32_t right = std::min(column + step, grid->columns - 1);
            const std::uint32_t low = std::min(row + step, grid->rows - 1);
            std::array<std::uint32_t, 4> quad{};
            for (std::size_t corner = 0; corner < 4; ++corner) {
                const std::uint32_t place = surface.faces.front()[corner];
                quad[corner] = (place >= grid->columns ? low : row) * grid->columns +
                               (place % grid->columns == 1 ? right : column);
            }
            triangles.push_back({quad[0], quad[1], quad[2]});
            triangles.push_back({quad[0], quad[2], quad[3]});
        }
    return triangles;
}

}  // namespace weft
