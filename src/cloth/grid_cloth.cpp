#include "cloth/grid_cloth.h"

#include <cmath>

namespace weft {

GridShape grid_shape(const GridDescription& grid) {
    GridShape shape;
    shape.columns = static_cast<std::size_t>(grid.resolution[0]);
    shape.rows = static_cast<std::size_t>(grid.resolution[1]);
    shape.dx = grid.size[0] / static_cast<double>(shape.columns - 1);
    shape.dy = grid.size[1] / static_cast<double>(shape.rows - 1);
    return shape;
}

Vec3d grid_position(const GridDescription& grid, std::size_t i, std::size_t j) {
    const double right =
        static_cast<double>(i) * grid.size[0] / static_cast<double>(grid.resolution[0] - 1);
    const double down =
        static_cast<double>(j) * grid.size[1] / static_cast<double>(grid.resolution[1] - 1);
    return grid.origin +
           (grid.plane == Plane::xy ? Vec3d{right, -down, 0.0} : Vec3d{right, 0.0, down});
}

GridSpringFamilies grid_spring_families(const GridShape& shape, StiffnessPer per,
                                        BendLayout bend_layout) {
    const auto [columns, rows, dx, dy] = shape;
    const double diagonal = std::hypot(dx, dy);
    const auto owners = [](std::size_t count, std::size_t reach) {
        return count > reach ? count - reach : 0;
    };
    using enum SpringKind;
    GridSpringFamilies families{{
        {structural, 0, 1, 0, owners(columns, 1), rows, dx},
        {structural, 0, 0, 1, columns, owners(rows, 1), dy},
        {shear, 0, 1, 1, owners(columns, 1), owners(rows, 1), diagonal},
        {shear, 1, 0, 1, owners(columns, 1), owners(rows, 1), diagonal},
        {bend, 0, 2, 0, owners(columns, 2), rows, 2 * dx},
        {bend, 0, 0, 2, columns, owners(rows, 2), 2 * dy},
    }};
    for (GridSpringFamily& family : families) {
        if (per == StiffnessPer::width) {
            const double strip = family.along_row() ? dy : dx;
            switch (family.kind) {
                case structural:
                    family.factor = strip / family.rest_length;
                    break;
                case shear:
                    family.factor = diagonal * diagonal / (2 * dx * dy);
                    break;
                case bend:
                    family.factor = strip / (2 * family.rest_length);
                    break;
            }
            family.border_factor = family.kind == shear ? family.factor : family.factor / 2;
        }
        if (family.kind == bend && bend_layout == BendLayout::border) family.factor = 0;
    }
    return families;
}

double grid_area(const GridShape& shape, std::size_t i, std::size_t j) {
    const bool side = i == 0 || i + 1 == shape.columns;
    const bool end = j == 0 || j + 1 == shape.rows;
    return shape.dx * shape.dy * (side ? 0.5 : 1.0) * (end ? 0.5 : 1.0);
}

Surface grid_surface(const GridShape& shape) {
    Surface surface;
    surface.particle_count = shape.particle_count();
    surface.uvs.reserve(surface.particle_count);
    for (std::size_t j = 0; j < shape.rows; ++j) {
        for (std::size_t i = 0; i < shape.columns; ++i) {
            surface.uvs.push_back(
                {static_cast<float>(i) / static_cast<float>(shape.columns - 1),
                 1.0f - static_cast<float>(j) / static_cast<float>(shape.rows - 1)});
        }
    }
    const std::size_t quads = (shape.columns - 1) * (shape.rows - 1);
    surface.faces.reserve(quads);
    surface.triangles.reserve(2 * quads);
    for (std::size_t j = 0; j + 1 < shape.rows; ++j) {
        for (std::size_t i = 0; i + 1 < shape.columns; ++i) {
            const auto top_left = static_cast<std::uint32_t>(shape.index(i, j));
            const auto bottom_left = static_cast<std::uint32_t>(shape.index(i, j + 1));
            const std::uint32_t top_right = top_left + 1, bottom_right = bottom_left + 1;
            surface.faces.push_back({top_left, bottom_left, bottom_right, top_right});
            surface.triangles.push_back({top_left, bottom_left, bottom_right});
            surface.triangles.push_back({top_left, bottom_right, top_right});
        }
    }
    return surface;
}

}  // namespace weft
