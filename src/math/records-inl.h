// Vectors of 3-D vectors from and to records {x, y, z, 0} of floats that stand anywhere in memory,
// for the instruction set being compiled; included once for each.
#if defined(WEFT_MATH_RECORDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_MATH_RECORDS_INL_H
#undef WEFT_MATH_RECORDS_INL_H
#else
#define WEFT_MATH_RECORDS_INL_H
#endif

#include <hwy/highway.h>

#include "math/simd-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// The records of lanes n, n + 4, n + 8 ..., a block of 128 bits each. The processor's own gather
// instructions take longer.
template <class D>
HWY_INLINE hn::Vec<D> every_fourth_record(D d, const float* HWY_RESTRICT records,
                                          const std::uint32_t* HWY_RESTRICT places) {
    const auto at = [&](int lane) HWY_ATTR { return records + places[lane]; };
#if HWY_TARGET == HWY_AVX3
    (void)d;
    __m512 r = _mm512_castps128_ps512(_mm_load_ps(at(0)));
    r = _mm512_mask_broadcast_f32x4(r, 0x00F0, _mm_load_ps(at(4)));
    r = _mm512_mask_broadcast_f32x4(r, 0x0F00, _mm_load_ps(at(8)));
    return hn::Vec<D>{_mm512_mask_broadcast_f32x4(r, 0xF000, _mm_load_ps(at(12)))};
#elif HWY_TARGET == HWY_AVX2
    const hn::Half<D> half;
    return hn::Combine(d, hn::Load(half, at(4)), hn::Load(half, at(0)));
#else
    return hn::Load(d, at(0));
#endif
}

/// Lane l's from records + places[l].
template <class D>
HWY_INLINE Pack<D> gather_records(D d, const float* HWY_RESTRICT records,
                                  const std::uint32_t* HWY_RESTRICT places) {
    const hn::Repartition<double, D> pairs;
    const auto r0 = every_fourth_record(d, records, places);
    const auto r1 = every_fourth_record(d, records, places + 1);
    const auto r2 = every_fourth_record(d, records, places + 2);
    const auto r3 = every_fourth_record(d, records, places + 3);
    const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(d, r0, r1));
    const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(d, r2, r3));
    const auto z01 = hn::BitCast(pairs, hn::InterleaveUpper(d, r0, r1));
    const auto z23 = hn::BitCast(pairs, hn::InterleaveUpper(d, r2, r3));
    return {hn::BitCast(d, hn::InterleaveLower(pairs, xy01, xy23)),
            hn::BitCast(d, hn::InterleaveUpper(pairs, xy01, xy23)),
            hn::BitCast(d, hn::InterleaveLower(pairs, z01, z23))};
}

/// Records of lanes one after the other.
template <class D>
HWY_INLINE void store_records(D d, const Pack<D>& p, float* records) {
    hn::StoreInterleaved4(p.x, p.y, p.z, hn::Zero(d), d, records);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
