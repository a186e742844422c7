#include "forces/grid_springs.h"

#include <algorithm>
#include <cmath>

namespace weft {

namespace {

template <typename Real>
struct TileForces {
    alignas(64) std::array<Real, GridSprings<Real>::tile> x, y, z;
};

// Force on side a of `count` springs between the runs a and b of one tile. Only with the results as
// restrict parameters does GCC vectorise: it gives up on so many possible overlaps.
template <typename Real, bool damped>
void tile_forces(std::size_t count, const Real* stiffness, const Real* damping, Real rest_length,
                 ConstVec3View<Real> xa, ConstVec3View<Real> xb, ConstVec3View<Real> va,
                 ConstVec3View<Real> vb, Real* __restrict fx, Real* __restrict fy,
                 Real* __restrict fz) {
    for (std::size_t n = 0; n < count; ++n) {
        const Real dx = xb.x[n] - xa.x[n], dy = xb.y[n] - xa.y[n], dz = xb.z[n] - xa.z[n];
        const Real length = std::sqrt(dx * dx + dy * dy + dz * dz);
        const Real inverse = length > 0 ? 1 / length : Real{0};
        Real tension = stiffness[n] * (length - rest_length);
        if constexpr (damped) {
            const Real rate =
                ((vb.x[n] - va.x[n]) * dx + (vb.y[n] - va.y[n]) * dy + (vb.z[n] - va.z[n]) * dz) *
                inverse;
            tension += damping[n] * rate;
        }
        const Real scale = tension * inverse;
        fx[n] = scale * dx;
        fy[n] = scale * dy;
        fz[n] = scale * dz;
    }
}

template <typename Real>
Vec3View<Real> offset(Vec3View<Real> a, std::size_t by) {
    return {a.x + by, a.y + by, a.z + by, a.size - by};
}

template <typename Real>
void add(std::size_t count, const TileForces<Real>& force, Vec3View<Real> f) {
    for (std::size_t n = 0; n < count; ++n) f.x[n] += force.x[n];
    for (std::size_t n = 0; n < count; ++n) f.y[n] += force.y[n];
    for (std::size_t n = 0; n < count; ++n) f.z[n] += force.z[n];
}

template <typename Real>
void subtract(std::size_t count, const TileForces<Real>& force, Vec3View<Real> f) {
    for (std::size_t n = 0; n < count; ++n) f.x[n] -= force.x[n];
    for (std::size_t n = 0; n < count; ++n) f.y[n] -= force.y[n];
    for (std::size_t n = 0; n < count; ++n) f.z[n] -= force.z[n];
}

template <typename Real>
GridSpringRow<Real> row_constants(const GridSpringFamily& family, const GridShape& shape,
                                  std::size_t row, const SpringMaterial& material) {
    GridSpringRow<Real> constants;
    for (std::size_t i = 0; i < family.owner_columns; ++i) {
        const double factor = family.spring_factor(i, row, shape);
        constants.stiffness.push_back(static_cast<Real>(material.stiffness * factor));
        constants.damping.push_back(static_cast<Real>(material.damping * factor));
        constants.damped |= constants.damping.back() != 0;
        constants.present |= constants.damped || constants.stiffness.back() != 0;
    }
    return constants;
}

}  // namespace

template <typename Real>
GridSprings<Real>::GridSprings(const ClothModel& cloth)
    : columns_(cloth.shape.columns), rows_(cloth.shape.rows) {
    const std::size_t inner_row = rows_ > 2 ? 1 : 0;
    for (std::size_t n = 0; n < families_.size(); ++n) {
        const GridSpringFamily& family = cloth.families[n];
        const SpringMaterial& material = cloth.materials[static_cast<std::size_t>(family.kind)];
        families_[n] = {family.ai,
                        family.bi,
                        family.bj,
                        family.owner_columns,
                        family.owner_rows,
                        static_cast<Real>(family.rest_length),
                        row_constants<Real>(family, cloth.shape, inner_row, material),
                        row_constants<Real>(family, cloth.shape, 0, material)};
    }
}

template <typename Real>
void GridSprings<Real>::add_forces(ConstVec3View<Real> x, ConstVec3View<Real> v, Vec3View<Real> f,
                                   std::size_t row_begin, std::size_t row_end) const {
    TileForces<Real> force;
    for (std::size_t j = row_begin > 2 ? row_begin - 2 : 0; j < row_end; ++j) {
        for (const GridSpringConstants<Real>& family : families_) {
            const GridSpringRow<Real>& row = row_of(family, j);
            const bool to_a = j >= row_begin;
            const bool to_b = j + family.bj >= row_begin && j + family.bj < row_end;
            if (j >= family.owner_rows || !row.present || (!to_a && !to_b)) continue;
            const auto compute = row.damped ? tile_forces<Real, true> : tile_forces<Real, false>;
            for (std::size_t i = 0; i < family.owner_columns; i += tile) {
                const std::size_t count = std::min(tile, family.owner_columns - i);
                const std::size_t a = j * columns_ + i + family.ai;
                const std::size_t b = (j + family.bj) * columns_ + i + family.bi;
                compute(count, row.stiffness.data() + i, row.damping.data() + i, family.rest_length,
                        offset(x, a), offset(x, b), offset(v, a), offset(v, b), force.x.data(),
                        force.y.data(), force.z.data());
                if (to_a) add(count, force, offset(f, a));
                if (to_b) subtract(count, force, offset(f, b));
            }
        }
    }
}

template <typename Real>
void GridSprings<Real>::add_forces_scalar(ConstVec3View<Real> x, ConstVec3View<Real> v,
                                          Vec3View<Real> f) const {
    const auto spring_force = [&](const GridSpringConstants<Real>& family, std::size_t i,
                                  std::size_t j, std::size_t p, std::size_t q) {
        const GridSpringRow<Real>& row = row_of(family, j);
        const Vec3<Real> d = x[q] - x[p];
        const Real length = weft::length(d);
        if (!(length > 0)) return Vec3<Real>{};
        const Real inverse = 1 / length;
        Real tension = row.stiffness[i] * (length - family.rest_length);
        if (row.damped) tension += row.damping[i] * (dot(v[q] - v[p], d) * inverse);
        return (tension * inverse) * d;
    };
    for (std::size_t j = 0; j < rows_; ++j) {
        for (const GridSpringConstants<Real>& family : families_) {
            if (j >= family.owner_rows || !row_of(family, j).present) continue;
            for (std::size_t begin = 0; begin < family.owner_columns; begin += tile) {
                const std::size_t end = std::min(begin + tile, family.owner_columns);
                for (const bool side_a : {true, false}) {
                    for (std::size_t i = begin; i < end; ++i) {
                        const std::size_t p = j * columns_ + i + family.ai;
                        const std::size_t q = (j + family.bj) * columns_ + i + family.bi;
                        const Vec3<Real> force = spring_force(family, i, j, p, q);
                        if (side_a) {
                            f.add(p, force);
                        } else {
                            f.add(q, -force);
                        }
                    }
                }
            }
        }
    }
}

template class GridSprings<float>;
template class GridSprings<double>;

}  // namespace weft
