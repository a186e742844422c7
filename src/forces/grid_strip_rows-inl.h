// Rows of a grid that stands in strips (GridStrips), for the instruction set being compiled;
// included once for each.
#if defined(WEFT_FORCES_GRID_STRIP_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_GRID_STRIP_ROWS_INL_H
#undef WEFT_FORCES_GRID_STRIP_ROWS_INL_H
#else
#define WEFT_FORCES_GRID_STRIP_ROWS_INL_H
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "forces/grid_rows-inl.h"
#include "math/pack-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// One array along one row of blocks of so many lines. Its places are counted in lanes, as if the
// vectors followed each other: vector n begins at n * Lanes.
template <typename Real, std::size_t lines>
struct StripRow {
    static constexpr std::size_t lanes = hn::MaxLanes(hn::ScalableTag<Real>());
    Real* x;

    [[nodiscard]] Real* vector(std::size_t i) const { return x + i * lines; }
};

template <class D, typename Real, std::size_t lines>
HWY_INLINE Pack<D> load(D d, const StripRow<Real, lines>& row, std::size_t i) {
    const Real* const x = row.vector(i);
    return {hn::Load(d, x), hn::Load(d, x + row.lanes), hn::Load(d, x + 2 * row.lanes)};
}

template <class D, typename Real, std::size_t lines>
HWY_INLINE void store(D d, const Pack<D>& value, const StripRow<Real, lines>& row, std::size_t i) {
    Real* const x = row.vector(i);
    hn::Store(value.x, d, x);
    hn::Store(value.y, d, x + row.lanes);
    hn::Store(value.z, d, x + 2 * row.lanes);
}

template <class D, typename Real, std::size_t lines>
HWY_INLINE hn::Vec<D> load_first(D d, const StripRow<Real, lines>& row, std::size_t i) {
    return hn::Load(d, row.vector(i));
}

// Of every lane the next column: the next vector.
template <int n, class D, typename Real, std::size_t lines>
HWY_INLINE Pack<D> load_ahead(D d, const Pack<D>& /*current*/, const StripRow<Real, lines>& row,
                              std::size_t i) {
    return load(d, row, i + n * hn::Lanes(d));
}

template <class D, typename Real, std::size_t lines>
HWY_INLINE Pack<D> load_next(D d, const Pack<D>& current, const StripRow<Real, lines>& row,
                             std::size_t i) {
    return load_ahead<1>(d, current, row, i);
}

// Asks for the block some blocks on. The processor sees one stream, and loses it wherever a page
// ends, after nine blocks of floats; asked for, it is there in time.
template <typename Real, std::size_t lines>
HWY_INLINE void prefetch(const StripRow<Real, lines>& row, std::size_t i) {
    constexpr std::size_t ahead = 20, line = 64 / sizeof(Real);  // blocks; numbers
    const Real* const block = row.vector(i + ahead * row.lanes);
    for (std::size_t n = 0; n < lines * row.lanes; n += line) hwy::Prefetch(block + n);
}

// What a vector puts one or two columns to the right, on its way there.
template <int n, class D>
class StripCarry {
    static_assert(n == 1 || n == 2);

public:
    HWY_INLINE explicit StripCarry(D d) : next_(zero_pack(d)), after_(next_) {}
    // @return what arrives where `sent` comes from.
    HWY_INLINE Pack<D> pass(D /*d*/, const Pack<D>& sent) {
        const Pack<D> arrived = next_;
        next_ = n == 1 ? sent : after_;
        if constexpr (n == 2) after_ = sent;
        return arrived;
    }
    // From the end of every strip to the beginning of the next.
    HWY_INLINE void to_next_strip(D d) {
        next_ = shift_in<1>(d, next_, zero_pack(d));
        after_ = shift_in<1>(d, after_, zero_pack(d));
    }

private:
    Pack<D> next_, after_;
};

// Where the rows of blocks stand for one band: its own in place, those around it in the halo.
template <typename Real, GridUpdate update>
class StripRows {
    static constexpr std::size_t lines = GridStrips<Real>::lines_of(update);

public:
    static constexpr bool in_strips = true;
    using Row = StripRow<Real, lines>;
    template <int n, class D>
    using CarryOf = StripCarry<n, D>;
    StripRows(const GridPass<Real>& pass, const GridBand<Real>& band) : pass_(pass), band_(band) {}

    enum Array : std::size_t { position = 0, velocity = 3, mass = 6, acceleration = 7 };

    [[nodiscard]] Row row(Array array, std::size_t j) const {
        return {blocks(j) + array * Row::lanes};
    }
    [[nodiscard]] Row row_like(const Row& /*other*/, Array array, std::size_t j) const {
        return row(array, j);
    }
    [[nodiscard]] Row masses(std::size_t j) const { return row(mass, j); }

    [[nodiscard]] std::size_t vectors() const { return pass_.strips.length; }
    // The last strip is the first that comes near the right border.
    [[nodiscard]] VectorRuns runs() const {
        const std::size_t length = pass_.strips.length, last = (Row::lanes - 1) * length;
        const std::size_t before = pass_.columns > last + 2 ? pass_.columns - 2 - last : 0;
        VectorRuns runs;
        runs.left = pass_.left_edge && before > 0 ? 1 : 0;
        runs.inner = before - runs.left;
        runs.right = length - before;
        return runs;
    }

    void put(const Vec3<Real>& value, const Row& row, std::size_t column) const {
        const std::size_t length = pass_.strips.length;
        Real* const x = row.vector(column % length * Row::lanes) + column / length;
        x[0] = value.x;
        x[Row::lanes] = value.y;
        x[2 * Row::lanes] = value.z;
    }

    // Puts where the strips of a row end what the next ones now begin with.
    HWY_INLINE void close(std::size_t j) const {
        const hn::ScalableTag<Real> d;
        const auto within = hn::FirstN(d, Row::lanes - 1);
        Real* const first = blocks(j);
        Real* const beyond = first + pass_.strips.length * lines * Row::lanes;
        for (std::size_t n = 0; n < GridStrips<Real>::blocks_beyond * lines; ++n) {
            if (n % lines >= mass) continue;
            const auto next = hn::LoadU(d, first + n * Row::lanes + 1);
            hn::Store(hn::IfThenElseZero(within, next), d, beyond + n * Row::lanes);
        }
    }

private:
    [[nodiscard]] Real* blocks(std::size_t j) const {
        if ((j >= band_.row_begin && j < band_.row_end) || band_.halo == nullptr) {
            return pass_.strips.blocks + j * pass_.strips.row_size;
        }
        return band_.halo + band_.halo_place(j) * pass_.strips.row_size;
    }

    const GridPass<Real>& pass_;
    const GridBand<Real>& band_;
};

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
