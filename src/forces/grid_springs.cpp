#include "forces/grid_springs.h"

namespace weft {

namespace {

// Force on particle a of the spring owned by column i; d = x_b - x_a, w = v_b - v_a.
template <typename Real>
Vec3<Real> spring_force(const GridSpringRow<Real>& row, std::size_t i, Real rest_length,
                        Vec3<Real> d, Vec3<Real> w) {
    const Real length = weft::length(d);
    if (!(length > 0)) return {};
    const Real inverse = 1 / length;
    Real tension = row.stiffness[i] * (length - rest_length);
    if (row.damped) tension += row.damping[i] * (dot(w, d) * inverse);
    return (tension * inverse) * d;
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
    : rows_(cloth.shape.rows), row_stride_(cloth.layout.row_stride()) {
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
    for (std::size_t j = row_begin > 2 ? row_begin - 2 : 0; j < row_end; ++j) {
        for (const GridSpringConstants<Real>& family : families_) {
            const GridSpringRow<Real>& row = row_of(family, j);
            const bool to_a = j >= row_begin;
            const bool to_b = j + family.bj >= row_begin && j + family.bj < row_end;
            if (j >= family.owner_rows || !row.present || (!to_a && !to_b)) continue;
            for (std::size_t i = 0; i < family.owner_columns; ++i) {
                const std::size_t a = j * row_stride_ + i + family.ai;
                const std::size_t b = (j + family.bj) * row_stride_ + i + family.bi;
                const Vec3<Real> force =
                    spring_force(row, i, family.rest_length, x[b] - x[a], v[b] - v[a]);
                if (to_a) f.add(a, force);
                if (to_b) f.add(b, -force);
            }
        }
    }
}

template class GridSprings<float>;
template class GridSprings<double>;

}  // namespace weft
