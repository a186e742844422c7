// Vectors of 3-D vectors from and to rows {x, y, z, -} that stand anywhere in memory, for the
// instruction set being compiled; included once for each.
#if defined(WEFT_FORCES_MESH_PASS_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_MESH_PASS_ROWS_INL_H
#undef WEFT_FORCES_MESH_PASS_ROWS_INL_H
#else
#define WEFT_FORCES_MESH_PASS_ROWS_INL_H
#endif

#include <hwy/highway.h>

#include "math/simd-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// Places and velocities of one particle a lane.
template <class D>
struct Moving {
    Pack<D> x, v;
};

// Blocks of 128 bits: {a0, b0, a1, b1} of each of a's and b's pairs of floats.
template <class D, class V>
HWY_INLINE V lower_pairs(D d, V a, V b) {
    const hn::Repartition<double, D> pairs;
    return hn::BitCast(d, hn::InterleaveLower(pairs, hn::BitCast(pairs, a), hn::BitCast(pairs, b)));
}
template <class D, class V>
HWY_INLINE V upper_pairs(D d, V a, V b) {
    const hn::Repartition<double, D> pairs;
    return hn::BitCast(d, hn::InterleaveUpper(pairs, hn::BitCast(pairs, a), hn::BitCast(pairs, b)));
}

// Floats: rows {x, y, z, -} in each block of 128 bits of a, b, c, e: in each block of the result
// four x (y, z) in this order.
template <class D, class V>
HWY_INLINE Pack<D> columns_of(D d, V a, V b, V c, V e) {
    const V ab = hn::InterleaveLower(d, a, b), ce = hn::InterleaveLower(d, c, e);
    const V ab_z = hn::InterleaveUpper(d, a, b), ce_z = hn::InterleaveUpper(d, c, e);
    return {lower_pairs(d, ab, ce), upper_pairs(d, ab, ce), lower_pairs(d, ab_z, ce_z)};
}

// The other way: rows {x, y, z, 0} of lanes 0, 1, 2, 3 of every block.
template <class D>
struct FourRows {
    hn::Vec<D> row[4];
};
template <class D>
HWY_INLINE FourRows<D> rows_of(D d, const Pack<D>& p) {
    const auto xy = hn::InterleaveLower(d, p.x, p.y), xy_up = hn::InterleaveUpper(d, p.x, p.y);
    const auto zero = hn::Zero(d);
    const auto z = hn::InterleaveLower(d, p.z, zero), z_up = hn::InterleaveUpper(d, p.z, zero);
    return {{lower_pairs(d, xy, z), upper_pairs(d, xy, z), lower_pairs(d, xy_up, z_up),
             upper_pairs(d, xy_up, z_up)}};
}

#if HWY_TARGET == HWY_AVX3

// {a.0, a.2, b.0, b.2} and {a.1, a.3, b.1, b.3} of blocks of 128 bits.
template <class V>
HWY_INLINE V even_blocks(V a, V b) {
    if constexpr (sizeof(a.raw[0]) == 4) {
        return V{_mm512_shuffle_f32x4(a.raw, b.raw, 0x88)};
    } else {
        return V{_mm512_shuffle_f64x2(a.raw, b.raw, 0x88)};
    }
}
template <class V>
HWY_INLINE V odd_blocks(V a, V b) {
    if constexpr (sizeof(a.raw[0]) == 4) {
        return V{_mm512_shuffle_f32x4(a.raw, b.raw, 0xDD)};
    } else {
        return V{_mm512_shuffle_f64x2(a.raw, b.raw, 0xDD)};
    }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
