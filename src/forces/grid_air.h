// The force of the air on a grid, per triangle, without index arrays, written to be read: quads row
// by row and from left to right, so that a band of rows alone gives the same bits as the whole
// grid.
#pragma once

#include <cstddef>

#include "cloth/grid_cloth.h"
#include "forces/plate_force.h"
#include "math/vec3_array.h"

namespace weft {

template <typename Real>
class GridAir {
public:
    /// @param row_stride slots from one row to the next, as of ParticleLayout::of_grid().
    GridAir(const WindDescription& wind, const GridShape& shape, std::size_t row_stride)
        : constants_(wind), columns_(shape.columns), rows_(shape.rows), row_stride_(row_stride) {}

    /// Adds to f the force on rows [row_begin, row_end) in the wind [m/s]. The triangles are those
    /// of grid_surface(). x, v, f: [slot]; padding is not touched.
    void add_forces(Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v, Vec3View<Real> f,
                    std::size_t row_begin, std::size_t row_end) const;

private:
    AirConstants<Real> constants_;
    std::size_t columns_, rows_, row_stride_;
};

extern template class GridAir<float>;
extern template class GridAir<double>;

}  // namespace weft
