#include "forces/grid_air.h"

#include <algorithm>
#include <array>

namespace weft {

namespace {

template <typename Real>
struct TileForces {
    alignas(64) std::array<Real, GridAir<Real>::tile> x, y, z;
};

// Thirds of the forces on `count` triangles whose corners run along three rows a, b, c from n0.
template <typename Real>
void tile_forces(const AirConstants<Real>& air, Vec3<Real> wind, ConstVec3View<Real> x,
                 ConstVec3View<Real> v, std::size_t a, std::size_t b, std::size_t c,
                 std::size_t count, Real* __restrict fx, Real* __restrict fy, Real* __restrict fz) {
    for (std::size_t n = 0; n < count; ++n) {
        const Vec3<Real> centre_velocity = Real(1.0 / 3.0) * (v[a + n] + v[b + n] + v[c + n]);
        const Vec3<Real> corner = x[a + n];
        const Vec3<Real> third = plate_force_third(air, wind - centre_velocity,
                                                   cross(x[b + n] - corner, x[c + n] - corner));
        fx[n] = third.x;
        fy[n] = third.y;
        fz[n] = third.z;
    }
}

template <typename Real>
void add(std::size_t count, const TileForces<Real>& force, Vec3View<Real> f, std::size_t at) {
    for (std::size_t n = 0; n < count; ++n) f.x[at + n] += force.x[n];
    for (std::size_t n = 0; n < count; ++n) f.y[at + n] += force.y[n];
    for (std::size_t n = 0; n < count; ++n) f.z[at + n] += force.z[n];
}

}  // namespace

template <typename Real>
void GridAir<Real>::add_forces(Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v,
                               Vec3View<Real> f, std::size_t row_begin, std::size_t row_end) const {
    TileForces<Real> lower, upper;
    for (std::size_t j = row_begin > 0 ? row_begin - 1 : 0; j < row_end && j + 1 < rows_; ++j) {
        for (std::size_t i = 0; i + 1 < columns_; i += tile) {
            const std::size_t count = std::min(tile, columns_ - 1 - i);
            const std::size_t top_left = j * columns_ + i, top_right = top_left + 1;
            const std::size_t bottom_left = top_left + columns_, bottom_right = bottom_left + 1;
            tile_forces(constants_, wind, x, v, top_left, bottom_left, bottom_right, count,
                        lower.x.data(), lower.y.data(), lower.z.data());
            tile_forces(constants_, wind, x, v, top_left, bottom_right, top_right, count,
                        upper.x.data(), upper.y.data(), upper.z.data());
            if (j >= row_begin) {
                add(count, lower, f, top_left);
                add(count, upper, f, top_left);
                add(count, upper, f, top_right);
            }
            if (j + 1 < row_end) {
                add(count, lower, f, bottom_left);
                add(count, lower, f, bottom_right);
                add(count, upper, f, bottom_right);
            }
        }
    }
}

template class GridAir<float>;
template class GridAir<double>;

}  // namespace weft
