// Rows of a grid's arrays, and where they stand for a band of rows, for the instruction set being
// compiled; included once for each.
#if defined(WEFT_FORCES_GRID_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_GRID_ROWS_INL_H
#undef WEFT_FORCES_GRID_ROWS_INL_H
#else
#define WEFT_FORCES_GRID_ROWS_INL_H
#endif

#include <hwy/highway.h>

#include "forces/grid_pass.h"
#include "math/pack-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// One array along one row: its x components, and how far on the y, then the z components stand.
// (Three pointers a row are more than there are registers.)
template <typename Real>
struct RowOf {
    Real* x;
    std::ptrdiff_t step;
};

template <class D, typename Real>
HWY_INLINE Pack<D> load(D d, const RowOf<Real>& row, std::size_t i) {
    const Real* const x = row.x + i;
    return load_pack(d, x, x + row.step, x + 2 * row.step);
}

template <class D, typename Real>
HWY_INLINE void store(D d, const Pack<D>& value, const RowOf<Real>& row, std::size_t i) {
    Real* const x = row.x + i;
    hn::StoreU(value.x, d, x);
    hn::StoreU(value.y, d, x + row.step);
    hn::StoreU(value.z, d, x + 2 * row.step);
}

// The vector n places after `current`, which stands at i. Where one instruction joins two vectors,
// that is cheaper than a load across a cache line.
template <int n, class D, typename Real>
HWY_INLINE Pack<D> load_ahead(D d, const Pack<D>& current, const RowOf<Real>& row, std::size_t i) {
#if HWY_TARGET == HWY_AVX3
    constexpr int back = static_cast<int>(64 / sizeof(Real)) - n;
    const Pack<D> next = load(d, row, i + hn::Lanes(d));
    return {shift_in<back>(d, next.x, current.x), shift_in<back>(d, next.y, current.y),
            shift_in<back>(d, next.z, current.z)};
#else
    (void)current;
    return load(d, row, i + n);
#endif
}

// The vector one place after `current`; for rows below, whose next vector is not needed otherwise.
template <class D, typename Real>
HWY_INLINE Pack<D> load_next(D d, const Pack<D>& /*current*/, const RowOf<Real>& row,
                             std::size_t i) {
    return load(d, row, i + 1);
}

// The x components alone.
template <class D, typename Real>
HWY_INLINE hn::Vec<D> load_first(D d, const RowOf<Real>& row, std::size_t i) {
    return hn::LoadU(d, row.x + i);
}

// The processor foresees these rows by itself.
template <typename Real>
HWY_INLINE void prefetch(const RowOf<Real>& /*row*/, std::size_t /*i*/) {}

// What a vector puts n columns to the right, on its way there.
template <int n, class D>
class Carry {
public:
    HWY_INLINE explicit Carry(D d) : last_(zero_pack(d)) {}
    // @return what arrives where `sent` comes from.
    HWY_INLINE Pack<D> pass(D d, const Pack<D>& sent) {
        const Pack<D> arrived = shift_in<n>(d, sent, last_);
        last_ = sent;
        return arrived;
    }

private:
    Pack<D> last_;
};

// How many vectors of a row are near the left border, inner ones, near the right border.
struct VectorRuns {
    std::size_t left = 0, inner = 0, right = 0;
};

// Where the rows of x, v and a stand for one band: its own in place, those around it in the halo.
template <typename Real>
class BandRows {
public:
    static constexpr bool in_strips = false;
    static constexpr std::size_t lanes = hn::MaxLanes(hn::ScalableTag<Real>());
    using Row = RowOf<Real>;
    template <int n, class D>
    using CarryOf = Carry<n, D>;
    BandRows(const GridPass<Real>& pass, const GridBand<Real>& band) : pass_(pass), band_(band) {}

    enum Array : std::size_t { position = 0, velocity = 3, acceleration = 6 };

    [[nodiscard]] RowOf<Real> row(Array array, std::size_t j) const {
        Real* const x = component(array, j);
        return {x, component(array + 1, j) - x};
    }
    // One whose components stand as far apart as those of another: an address less to keep.
    [[nodiscard]] Row row_like(const Row& other, Array array, std::size_t j) const {
        return {component(array, j), other.step};
    }
    // To be read: its first components are inverse masses.
    [[nodiscard]] Row masses(std::size_t j) const {
        return {const_cast<Real*>(pass_.inverse_masses) + j * pass_.stride, 0};
    }

    [[nodiscard]] std::size_t vectors() const { return (pass_.columns + lanes - 1) / lanes; }
    // The springs of inner vectors end two columns before the border.
    [[nodiscard]] VectorRuns runs() const {
        VectorRuns runs;
        runs.left = pass_.left_edge || lanes + 2 > pass_.columns ? 1 : 0;
        const std::size_t begin = runs.left * lanes;
        if (pass_.columns >= begin + lanes + 2) runs.inner = (pass_.columns - 2 - begin) / lanes;
        runs.right = vectors() - runs.left - runs.inner;
        return runs;
    }

    void put(const Vec3<Real>& value, const Row& row, std::size_t column) const {
        Real* const x = row.x + column;
        x[0] = value.x;
        x[row.step] = value.y;
        x[2 * row.step] = value.z;
    }
    void close(std::size_t /*j*/) const {}

private:
    [[nodiscard]] Real* component(std::size_t c, std::size_t j) const {
        const bool own = j >= band_.row_begin && j < band_.row_end;
        if (own || band_.halo == nullptr) {
            Real* const base = c < 3 ? pass_.x[c] : c < 6 ? pass_.v[c - 3] : pass_.a[c - 6];
            return base + j * pass_.stride;
        }
        return band_.halo + (c * GridBand<Real>::halo_rows + band_.halo_place(j)) * pass_.stride;
    }

    const GridPass<Real>& pass_;
    const GridBand<Real>& band_;
};

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
