#include "forces/grid_air.h"

namespace weft {

template <typename Real>
void GridAir<Real>::add_forces(Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v,
                               Vec3View<Real> f, std::size_t row_begin, std::size_t row_end) const {
    const auto third_of = [&](std::size_t a, std::size_t b, std::size_t c) {
        const Vec3<Real> centre_velocity = Real(1.0 / 3.0) * (v[a] + v[b] + v[c]);
        const Vec3<Real> normal = cross(x[b] - x[a], x[c] - x[a]);
        return plate_force_third(constants_, wind - centre_velocity, normal);
    };
    for (std::size_t j = row_begin > 0 ? row_begin - 1 : 0; j < row_end && j + 1 < rows_; ++j) {
        for (std::size_t i = 0; i + 1 < columns_; ++i) {
            const std::size_t top_left = j * row_stride_ + i, top_right = top_left + 1;
            const std::size_t bottom_left = top_left + row_stride_, bottom_right = bottom_left + 1;
            const Vec3<Real> lower = third_of(top_left, bottom_left, bottom_right);
            const Vec3<Real> upper = third_of(top_left, bottom_right, top_right);
            if (j >= row_begin) {
                f.add(top_left, lower);
                f.add(top_left, upper);
                f.add(top_right, upper);
            }
            if (j + 1 < row_end) {
                f.add(bottom_left, lower);
                f.add(bottom_right, lower);
                f.add(bottom_right, upper);
            }
        }
    }
}

template class GridAir<float>;
template class GridAir<double>;

}  // namespace weft
