// The force of the air on a grid, per triangle, without index arrays: rows of quads in rising order
// and tiles of columns, as GridSprings.
#pragma once

#include <cstddef>

#include "cloth/grid_cloth.h"
#include "forces/plate_force.h"
#include "math/vec3_array.h"

namespace weft {

template <typename Real>
class GridAir {
public:
    static constexpr std::size_t tile = 256;  ///< quads a buffer holds

    GridAir(const WindDescription& wind, const GridShape& shape)
        : constants_(wind), columns_(shape.columns), rows_(shape.rows) {}

    /// Adds to f the force on rows [row_begin, row_end) in the wind [m/s]. The triangles are those
    /// of grid_surface().
    void add_forces(Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v, Vec3View<Real> f,
                    std::size_t row_begin, std::size_t row_end) const;

private:
    AirConstants<Real> constants_;
    std::size_t columns_, rows_;
};

extern template class GridAir<float>;
extern template class GridAir<double>;

}  // namespace weft
