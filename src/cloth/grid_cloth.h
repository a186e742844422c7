// The springs, areas and surface of a rectangular grid. Springs are not listed: six families, each
// one offset repeated over the grid, say all.
#pragma once

#include <array>
#include <cstddef>

#include "cloth/springs.h"
#include "weft/frame.h"
#include "weft/scene.h"

namespace weft {

/// Size of a grid: particle (column i, row j) has index j * columns + i.
struct GridShape {
    std::size_t columns = 0, rows = 0;
    double dx = 0.0, dy = 0.0;  ///< distance of columns, of rows [m]

    [[nodiscard]] std::size_t particle_count() const { return columns * rows; }
    [[nodiscard]] std::size_t index(std::size_t i, std::size_t j) const { return j * columns + i; }
};

GridShape grid_shape(const GridDescription& grid);

/// Where particle (i, j) starts [m].
Vec3d grid_position(const GridDescription& grid, std::size_t i, std::size_t j);

/// The springs of one offset: owner (i, j) joins particles (i + ai, j) and (i + bi, j + bj).
///
///     (i,j)---(1,0)---(i+1,j)---- (2,0) ---->(i+2,j)
///       | \           / |
///     (0,1) (1,1)  anti |          anti joins (i+1,j) with (i,j+1)
///       | /           \ |
///     (i,j+1)------(i+1,j+1)
///       |
///     (0,2)
///       v
///
/// A spring's stiffness is the kind's, times row_factor(j) * column_factor(i).
struct GridSpringFamily {
    SpringKind kind = SpringKind::structural;
    std::size_t ai = 0, bi = 0, bj = 0;
    std::size_t owner_columns = 0,
                owner_rows = 0;  ///< owners are i < owner_columns, j < owner_rows
    double rest_length = 0.0;    ///< [m]
    double factor = 1.0;         ///< of an inner spring [1]
    double border_factor = 1.0;  ///< of a spring along a border line [1]

    [[nodiscard]] bool along_row() const { return bj == 0; }
    [[nodiscard]] bool along_column() const { return ai == bi; }

    /// Factor on the kind's stiffness and damping of the spring owned by (i, j); 0: no such spring.
    [[nodiscard]] double spring_factor(std::size_t i, std::size_t j, const GridShape& shape) const {
        const bool border = (along_row() && (j == 0 || j + 1 == shape.rows)) ||
                            (along_column() && (i == 0 || i + 1 == shape.columns));
        return border ? border_factor : factor;
    }
};

inline constexpr std::size_t grid_family_count = 6;
using GridSpringFamilies = std::array<GridSpringFamily, grid_family_count>;

/// The six families: structural (1,0) and (0,1), shear (1,1) and anti, bend (2,0) and (0,2).
/// Per spring every factor is 1. Per width K the tension of a strip of width w at unit strain is
/// K w, so k = K w / L, with w the distance of the neighbouring rows (half of it on a border line;
/// half again for bend springs, of which two overlap everywhere); shear k = K L^2 / (2 dx dy) gives
/// the shear modulus K.
GridSpringFamilies grid_spring_families(const GridShape& shape, StiffnessPer per,
                                        BendLayout bend_layout);

/// Area nearest to particle (i, j): dx dy, half on a border, a quarter at a corner [m2].
double grid_area(const GridShape& shape, std::size_t i, std::size_t j);

/// Quads from left to right and top to bottom, each two triangles along the diagonal from its top
/// left to its bottom right; front is +z for plane xy and +y for xz. UV (0, 1) is particle (0, 0).
Surface grid_surface(const GridShape& shape);

}  // namespace weft
