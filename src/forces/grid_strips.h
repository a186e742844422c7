// A grid's state in strips: what the fast pass moves while nobody looks at the steps.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "forces/grid_pass.h"
#include "math/line_aligned.h"
#include "math/vec3_array.h"

namespace weft {

template <typename Real>
class GridStripState {
public:
    GridStripState() = default;
    /// @param lanes of a vector.
    GridStripState(std::size_t columns, std::size_t rows, std::size_t stride, std::size_t lanes);

    /// Whether steps are faster in strips than on arrays, by so much that copying pays after a few.
    [[nodiscard]] bool pays() const;

    /// Copies a state into strips; the first call allocates.
    /// @param inverse_masses [slot]  @param a of velocity Verlet, else without size.
    void take(ConstVec3View<Real> x, ConstVec3View<Real> v, const Real* inverse_masses,
              ConstVec3View<Real> a);
    /// Copies it back.  @param a as for take().
    void give(Vec3View<Real> x, Vec3View<Real> v, Vec3View<Real> a);
    /// Puts one particle.
    void put(std::size_t slot, Vec3<Real> x, Vec3<Real> v) const;

    /// Factors of the columns of a row, [stride], in the order of vectors and lanes.
    [[nodiscard]] std::vector<Real> in_strips(std::span<const Real> factors) const;

    /// Numbers of a row with everything in it.
    [[nodiscard]] std::size_t largest_row() const {
        return GridStrips<Real>::size_of_row(
            strips_.length, GridStrips<Real>::lines_of(GridUpdate::verlet) * lanes_);
    }
    /// What a pass needs; blocks are null unless a state is here.
    [[nodiscard]] const GridStrips<Real>& strips() const { return strips_; }

private:
    template <typename Copy>
    void for_columns(std::size_t array, std::size_t j, const Copy& copy) const;
    // Repeats the beginnings of a row's strips beyond its last block.
    void close(std::size_t j) const;

    std::size_t columns_ = 0, rows_ = 0, stride_ = 0, lanes_ = 0;
    std::size_t lines_ = 0;  // of a block
    GridStrips<Real> strips_;
    LineAligned<Real> blocks_;
};

extern template class GridStripState<float>;
extern template class GridStripState<double>;

}  // namespace weft
