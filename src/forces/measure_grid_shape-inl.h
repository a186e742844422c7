// Normals, copies and hashes of forces/measure_grid.h with the vectors of one instruction set;
// included once for each.
#if defined(WEFT_FORCES_MEASURE_GRID_SHAPE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_MEASURE_GRID_SHAPE_INL_H
#undef WEFT_FORCES_MEASURE_GRID_SHAPE_INL_H
#else
#define WEFT_FORCES_MEASURE_GRID_SHAPE_INL_H
#endif

#include <hwy/highway.h>

#include <bit>

#include "forces/grid_pass-inl.h"
#include "forces/measure_grid.h"
#include "math/random.h"
#include "math/simd-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

static_assert(sizeof(Vec3f) == 3 * sizeof(float) && sizeof(Vec3d) == 3 * sizeof(double));

// Writes the first `count` vectors of a pack one after the other, x, y, z.
template <class D>
HWY_INLINE void store_interleaved(D d, const Pack<D>& pack, std::size_t count, hn::TFromD<D>* out) {
    constexpr std::size_t most = hn::MaxLanes(D());
    if (count >= hn::Lanes(d)) {
        hn::StoreInterleaved3(pack.x, pack.y, pack.z, d, out);
    } else {
        HWY_ALIGN hn::TFromD<D> all[3 * most];
        hn::StoreInterleaved3(pack.x, pack.y, pack.z, d, all);
        std::copy_n(all, 3 * count, out);
    }
}

// The places around each particle of a vector of columns, clockwise on a hanging sheet seen from
// its front. Beyond a border stands the particle itself: triangles there have no area.
//
//     up_left --- up
//        |  \     |  \            .
//       left --- own --- right
//           \     |  \   |
//               down -- down_right
template <class D>
struct Neighbours {
    Pack<D> left, up_left, up, right, down_right, down;

    // The sum of the cross products of the six triangles' sides, twice their area along their
    // normals: that of a closed hexagon, which is two quads.
    HWY_INLINE Pack<D> twice_area() const {
        return plus(cross(minus(right, down), minus(up, down_right)),
                    cross(minus(left, up), minus(down, up_left)));
    }
};

// What stands one column to the left: the vector before goes on, or column 0 is its own neighbour.
template <class D, typename Real>
HWY_INLINE Pack<D> load_left(D d, const RowOf<const Real>& row, std::size_t i) {
    if (i > 0) return load(d, row, i - 1);
    const Pack<D> own = load(d, row, 0);
    return {shift_in<1>(d, own.x, hn::Set(d, row.x[0])),
            shift_in<1>(d, own.y, hn::Set(d, row.x[row.step])),
            shift_in<1>(d, own.z, hn::Set(d, row.x[2 * row.step]))};
}

// One column to the right; the last column is its own neighbour.
template <class D, typename Real>
HWY_INLINE Pack<D> load_right(D d, const RowOf<const Real>& row, std::size_t i,
                              std::size_t columns) {
    const Pack<D> next = load(d, row, i + 1);
    if (i + hn::Lanes(d) < columns) return next;
    const auto inside = hn::FirstN(d, columns - 1 - i);
    const Pack<D> own = load(d, row, i);
    return {hn::IfThenElse(inside, next.x, own.x), hn::IfThenElse(inside, next.y, own.y),
            hn::IfThenElse(inside, next.z, own.z)};
}

template <class D>
HWY_INLINE Pack<D> unit_or_zero(D d, const Pack<D>& n) {
    const auto norm = hn::Sqrt(dot(n, n));
    const auto inverse =
        hn::IfThenElseZero(hn::Gt(norm, hn::Zero(d)), hn::Div(hn::Set(d, hn::TFromD<D>{1}), norm));
    return times(inverse, n);
}

HWY_INLINE void store_rounded(hn::ScalableTag<float> d, const Pack<hn::ScalableTag<float>>& n,
                              std::size_t count, Vec3f* out) {
    store_interleaved(d, n, count, &out->x);
}
HWY_INLINE void store_rounded(hn::ScalableTag<double>, const Pack<hn::ScalableTag<double>>& n,
                              std::size_t count, Vec3f* out) {
    using F = hn::Rebind<float, hn::ScalableTag<double>>;
    const F f;
    const Pack<F> rounded{hn::DemoteTo(f, n.x), hn::DemoteTo(f, n.y), hn::DemoteTo(f, n.z)};
    store_interleaved(f, rounded, count, &out->x);
}

template <typename Real>
HWY_INLINE void measure_normals(const GridMeasure<Real>& grid, ConstVec3View<Real> x,
                                std::size_t begin, std::size_t end, Vec3f* out) {
    using D = hn::ScalableTag<Real>;
    const D d;
    const auto row = [&](std::size_t j) HWY_ATTR {
        const std::size_t first = j * grid.stride;
        return RowOf<const Real>{x.x + first, x.y - x.x};
    };
    for (std::size_t j = begin; j < end; ++j) {
        const auto above = row(j > 0 ? j - 1 : 0), own = row(j);
        const auto below = row(j + 1 < grid.rows ? j + 1 : j);
        for (std::size_t i = 0; i < grid.columns; i += hn::Lanes(d)) {
            const Neighbours<D> around{load_left(d, own, i),
                                       load_left(d, above, i),
                                       load(d, above, i),
                                       load_right(d, own, i, grid.columns),
                                       load_right(d, below, i, grid.columns),
                                       load(d, below, i)};
            store_rounded(d, unit_or_zero(d, around.twice_area()), grid.columns - i,
                          out + j * grid.columns + i);
        }
    }
}

template <class D>
HWY_INLINE Pack<D> load_for_copy(D d, const double* x, const double* y, const double* z) {
    return load_pack(d, x, y, z);
}
template <class D>
HWY_INLINE Pack<D> load_for_copy(D d, const float* x, const float* y, const float* z) {
    const hn::Rebind<float, D> df;
    return {hn::PromoteTo(d, hn::LoadU(df, x)), hn::PromoteTo(d, hn::LoadU(df, y)),
            hn::PromoteTo(d, hn::LoadU(df, z))};
}

template <typename Real>
HWY_INLINE void measure_copy(const GridMeasure<Real>& grid, ConstVec3View<Real> x,
                             std::size_t begin, std::size_t end, Vec3d* out) {
    const hn::ScalableTag<double> d;
    for (std::size_t j = begin; j < end; ++j) {
        for (std::size_t i = 0; i < grid.columns; i += hn::Lanes(d)) {
            const std::size_t slot = j * grid.stride + i;
            store_interleaved(d, load_for_copy(d, x.x + slot, x.y + slot, x.z + slot),
                              grid.columns - i, &out[j * grid.columns + i].x);
        }
    }
}

template <typename Real>
HWY_INLINE void measure_copy_rounded(const GridMeasure<Real>& grid, ConstVec3View<Real> x,
                                     std::size_t begin, std::size_t end, Vec3f* out) {
    const hn::ScalableTag<Real> d;
    for (std::size_t j = begin; j < end; ++j) {
        for (std::size_t i = 0; i < grid.columns; i += hn::Lanes(d)) {
            const std::size_t slot = j * grid.stride + i;
            store_rounded(d, load_pack(d, x.x + slot, x.y + slot, x.z + slot), grid.columns - i,
                          out + j * grid.columns + i);
        }
    }
}

// A plain loop, which the compiler makes vectors of where the set multiplies 64-bit numbers.
template <typename Real>
HWY_INLINE std::uint64_t measure_hash(const Real* values, std::size_t count, std::uint64_t key,
                                      std::uint64_t key_step) {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    std::uint64_t sum = 0;
    for (std::size_t n = 0; n < count; ++n) {
        sum += mix_bits(std::bit_cast<Bits>(values[n]) + key + n * key_step);
    }
    return sum;
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
