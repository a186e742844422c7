// Strain and energies of forces/measure_grid.h with the vectors of one instruction set; included
// once for each.
#if defined(WEFT_FORCES_MEASURE_GRID_STRAIN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_MEASURE_GRID_STRAIN_INL_H
#undef WEFT_FORCES_MEASURE_GRID_STRAIN_INL_H
#else
#define WEFT_FORCES_MEASURE_GRID_STRAIN_INL_H
#endif

#include <hwy/highway.h>

#include <limits>

#include "forces/grid_pass-inl.h"
#include "forces/measure_grid.h"
#include "math/simd-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

template <typename Real>
HWY_INLINE RowOf<const Real> row_of(const GridMeasure<Real>& grid, ConstVec3View<Real> view,
                                    std::size_t j) {
    // Rows below the last have no springs to them.
    const std::size_t first = (j < grid.rows ? j : grid.rows - 1) * grid.stride;
    return {view.x + first, view.y - view.x};
}

// Calls spring(family, dx) for the springs that the vector of columns from i on owns; dx: to their
// other end. load(row, i) gives places.
template <class D, typename Real, class Load, class Spring>
HWY_INLINE void for_each_owned(const std::array<RowOf<const Real>, 3>& rows, std::size_t i,
                               const Load& load_at, const Spring& spring) {
    const Pack<D> x = load_at(rows[0], i), right = load_at(rows[0], i + 1);
    const Pack<D> below = load_at(rows[1], i);
    spring(along_row, minus(right, x));
    spring(along_column, minus(below, x));
    spring(shear, minus(load_at(rows[1], i + 1), x));
    spring(anti, minus(below, right));
    spring(bend_row, minus(load_at(rows[0], i + 2), x));
    spring(bend_column, minus(load_at(rows[2], i), x));
}

// The strain of one row's springs, vector by vector.
template <class D>
class StrainRow {
    using T = hn::TFromD<D>;
    using V = hn::Vec<D>;
    using View = ConstVec3View<T>;

public:
    HWY_INLINE StrainRow(const GridMeasure<T>& grid, View x, View v, std::size_t j)
        : grid_(grid),
          x_{row_of(grid, x, j), row_of(grid, x, j + 1), row_of(grid, x, j + 2)},
          v_(row_of(grid, v, j)) {
        for (std::size_t n = 0; n < grid_family_count; ++n) {
            in_row_[n] = grid.families[n].rows[j] != 0;
            in_row_inside_[n] = in_row_[n] && grid.families[n].inner;
        }
    }

    HWY_INLINE RatioRange<T> sweep() {
        const std::size_t lanes = hn::Lanes(D());
        std::size_t i = 0;
        if (grid_.left_edge || lanes + 2 > grid_.columns) {
            vectors<true>(0, 1);
            i = lanes;
        }
        // Inner vectors: their springs end two columns before the border.
        std::size_t count = 0;
        if (grid_.columns >= i + lanes + 2) count = (grid_.columns - 2 - i) / lanes;
        vectors<false>(i, count);
        i += count * lanes;
        vectors<true>(i, i < grid_.columns ? (grid_.columns - i + lanes - 1) / lanes : 0);

        const D d;
        const V nought = hn::Add(nought_.x, hn::Add(nought_.y, nought_.z));
        const bool finite = hn::AllTrue(d, hn::Eq(nought, hn::Zero(d)));
        return {
            hn::GetLane(hn::MinOfLanes(d, smallest_)),
            finite ? hn::GetLane(hn::MaxOfLanes(d, largest_)) : std::numeric_limits<T>::infinity()};
    }

private:
    template <bool edge>
    HWY_INLINE void vectors(std::size_t i, std::size_t count) {
        const D d;
        const auto& present = edge ? in_row_ : in_row_inside_;
        V smallest = smallest_, largest = largest_;
        Pack<D> nought = nought_;
        const V zero = hn::Zero(d);
        for (const std::size_t end = i + count * hn::Lanes(d); i < end; i += hn::Lanes(d)) {
            // Zero, or NaN where a factor is not finite.
            nought = plus_scaled(nought, zero, load(d, x_[0], i));
            nought = plus_scaled(nought, zero, load(d, v_, i));
            for_each_owned<D>(
                x_, i,
                [&](const RowOf<const T>& row, std::size_t k) HWY_ATTR { return load(d, row, k); },
                [&](Family n, const Pack<D>& dx) HWY_ATTR {
                    if (!present[n]) return;
                    const auto& family = grid_.families[n];
                    V ratio = hn::Mul(dot(dx, dx), hn::Set(d, family.inverse_square));
                    if constexpr (edge) {
                        const auto owned = hn::Gt(hn::LoadU(d, family.columns + i), zero);
                        ratio = hn::IfThenElse(owned, ratio, hn::Set(d, T{1}));
                    }
                    smallest = hn::Min(smallest, ratio);
                    largest = hn::Max(largest, ratio);
                });
        }
        smallest_ = smallest;
        largest_ = largest;
        nought_ = nought;
    }

    const GridMeasure<T>& grid_;
    const std::array<RowOf<const T>, 3> x_;
    const RowOf<const T> v_;
    std::array<bool, grid_family_count> in_row_{}, in_row_inside_{};
    const V one_ = hn::Set(D(), T{1}), zero_ = hn::Zero(D());
    V smallest_ = one_, largest_ = one_;
    Pack<D> nought_{zero_, zero_, zero_};
};

template <typename Real>
HWY_INLINE void measure_strain(const GridMeasure<Real>& grid, ConstVec3View<Real> x,
                               ConstVec3View<Real> v, std::size_t begin, std::size_t end,
                               RatioRange<Real>* out) {
    for (std::size_t j = begin; j < end; ++j) {
        out[j] = StrainRow<hn::ScalableTag<Real>>(grid, x, v, j).sweep();
    }
}

// Places and velocities in double, whatever they are kept in.
template <class D>
HWY_INLINE Pack<D> load_double(D d, const RowOf<const double>& row, std::size_t i) {
    return load(d, row, i);
}
template <class D>
HWY_INLINE Pack<D> load_double(D d, const RowOf<const float>& row, std::size_t i) {
    const hn::Rebind<float, D> df;
    return {hn::PromoteTo(d, hn::LoadU(df, row.x + i)),
            hn::PromoteTo(d, hn::LoadU(df, row.x + row.step + i)),
            hn::PromoteTo(d, hn::LoadU(df, row.x + 2 * row.step + i))};
}

// The masses of a vector of columns, of which the row has `count` more: zero for the others.
template <class D>
HWY_INLINE hn::Vec<D> load_masses(D d, const double* masses, std::size_t count) {
    if (count >= hn::Lanes(d)) return hn::LoadU(d, masses);
    HWY_ALIGN double some[hn::MaxLanes(D())] = {};
    std::copy_n(masses, count, some);
    return hn::Load(d, some);
}

template <typename Real>
HWY_INLINE Energy energy_of_row(const GridMeasure<Real>& grid, ConstVec3View<Real> x_view,
                                ConstVec3View<Real> v_view, std::size_t j) {
    using D = hn::ScalableTag<double>;
    using V = hn::Vec<D>;
    const D d;
    const std::array<RowOf<const Real>, 3> rows{
        row_of(grid, x_view, j), row_of(grid, x_view, j + 1), row_of(grid, x_view, j + 2)};
    const RowOf<const Real> velocities = row_of(grid, v_view, j);
    const double* const masses = grid.masses + j * grid.columns;
    const V zero = hn::Zero(d);
    V kinetic = zero, gravity = zero, structural = zero, sheared = zero, bend = zero;
    const Pack<D> g{hn::Set(d, grid.gravity.x), hn::Set(d, grid.gravity.y),
                    hn::Set(d, grid.gravity.z)};
    for (std::size_t i = 0; i < grid.columns; i += hn::Lanes(d)) {
        const V mass = load_masses(d, masses + i, grid.columns - i);
        const Pack<D> v = load_double(d, velocities, i);
        kinetic = hn::MulAdd(mass, dot(v, v), kinetic);
        gravity = hn::MulAdd(mass, dot(g, load_double(d, rows[0], i)), gravity);
        for_each_owned<D>(
            rows, i,
            [&](const RowOf<const Real>& row, std::size_t k)
                HWY_ATTR { return load_double(d, row, k); },
            [&](Family n, const Pack<D>& dx) HWY_ATTR {
                const auto& family = grid.families[n];
                const double factor = family.rows[j];
                if (factor == 0) return;
                const V stretch = hn::Sub(hn::Sqrt(dot(dx, dx)), hn::Set(d, family.rest_length));
                const V stiffness = hn::Mul(hn::LoadU(d, family.stiffness + i), hn::Set(d, factor));
                V& sum = n == along_row || n == along_column ? structural
                         : n == shear || n == anti           ? sheared
                                                             : bend;
                sum = hn::MulAdd(hn::Mul(stiffness, stretch), stretch, sum);
            });
    }
    const auto total = [&](const V& sum) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, sum)); };
    return {0.5 * total(kinetic), -total(gravity), total(structural), total(sheared), total(bend)};
}

template <typename Real>
HWY_INLINE void measure_energy(const GridMeasure<Real>& grid, ConstVec3View<Real> x,
                               ConstVec3View<Real> v, std::size_t begin, std::size_t end,
                               Energy* out) {
    for (std::size_t j = begin; j < end; ++j) out[j] = energy_of_row(grid, x, v, j);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
