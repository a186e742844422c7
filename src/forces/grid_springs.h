// Spring forces on a grid, written to be read: each spring computed once, without index arrays.
// Fast kernels are held against this one.
//
// Source rows are taken in rising order, within a row the six families of GridSpringFamily, and
// within a family its springs from left to right. So each particle's sum has one order, and a band
// of rows alone gives the same bits as the whole grid: it recomputes the two rows above itself,
// whose springs reach into it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cloth/cloth_model.h"
#include "math/vec3_array.h"

namespace weft {

/// Constants of one family along one row of owners, in the precision of the run.
template <typename Real>
struct GridSpringRow {
    std::vector<Real> stiffness, damping;  ///< [owner column], width factors applied
    bool present = false;                  ///< any of them is not zero
    bool damped = false;                   ///< any damping is not zero
};

template <typename Real>
struct GridSpringConstants {
    std::size_t ai = 0, bi = 0, bj = 0;  ///< as in GridSpringFamily
    std::size_t owner_columns = 0, owner_rows = 0;
    Real rest_length = 0;
    GridSpringRow<Real> inner_row, border_row;  ///< border: the grid's first and last row
};

template <typename Real>
class GridSprings {
public:
    explicit GridSprings(const ClothModel& cloth);

    /// Adds to f the spring and dashpot forces on rows [row_begin, row_end):
    ///     f_p = (k (|d| - L) + c (v_q - v_p).u) u,  d = x_q - x_p, u = d / |d|
    /// and nothing where |d| = 0. x, v, f: [slot] of the cloth's layout; padding is not touched.
    void add_forces(ConstVec3View<Real> x, ConstVec3View<Real> v, Vec3View<Real> f,
                    std::size_t row_begin, std::size_t row_end) const;

private:
    [[nodiscard]] const GridSpringRow<Real>& row_of(const GridSpringConstants<Real>& family,
                                                    std::size_t j) const {
        return j == 0 || j + 1 == rows_ ? family.border_row : family.inner_row;
    }

    std::size_t rows_, row_stride_;
    std::array<GridSpringConstants<Real>, grid_family_count> families_;
};

extern template class GridSprings<float>;
extern template class GridSprings<double>;

}  // namespace weft
