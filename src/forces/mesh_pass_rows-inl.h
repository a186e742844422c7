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

#if HWY_TARGET == HWY_AVX3
// Of blocks of 128 bits: {a.0, a.2, b.0, b.2} and {a.1, a.3, b.1, b.3}.
template <class D>
HWY_INLINE hn::Vec<D> even_blocks(D, hn::Vec<D> a, hn::Vec<D> b) {
    if constexpr (sizeof(hn::TFromD<D>) == 4) {
        return hn::Vec<D>{_mm512_shuffle_f32x4(a.raw, b.raw, 0x88)};
    } else {
        return hn::Vec<D>{_mm512_shuffle_f64x2(a.raw, b.raw, 0x88)};
    }
}
template <class D>
HWY_INLINE hn::Vec<D> odd_blocks(D, hn::Vec<D> a, hn::Vec<D> b) {
    if constexpr (sizeof(hn::TFromD<D>) == 4) {
        return hn::Vec<D>{_mm512_shuffle_f32x4(a.raw, b.raw, 0xDD)};
    } else {
        return hn::Vec<D>{_mm512_shuffle_f64x2(a.raw, b.raw, 0xDD)};
    }
}
#elif HWY_TARGET == HWY_AVX2
// Of blocks of 128 bits: {a.0, b.0} and {a.1, b.1}.
template <class D>
HWY_INLINE hn::Vec<D> even_blocks(D d, hn::Vec<D> a, hn::Vec<D> b) {
    return hn::ConcatLowerLower(d, b, a);
}
template <class D>
HWY_INLINE hn::Vec<D> odd_blocks(D d, hn::Vec<D> a, hn::Vec<D> b) {
    return hn::ConcatUpperUpper(d, b, a);
}
#endif

// Within each block of 128 bits: the lower, or the upper, pairs of floats of a and b.
template <class D>
HWY_INLINE hn::Vec<D> lower_pairs(D d, hn::Vec<D> a, hn::Vec<D> b) {
    const hn::Repartition<double, D> pairs;
    return hn::BitCast(d, hn::InterleaveLower(pairs, hn::BitCast(pairs, a), hn::BitCast(pairs, b)));
}
template <class D>
HWY_INLINE hn::Vec<D> upper_pairs(D d, hn::Vec<D> a, hn::Vec<D> b) {
    const hn::Repartition<double, D> pairs;
    return hn::BitCast(d, hn::InterleaveUpper(pairs, hn::BitCast(pairs, a), hn::BitCast(pairs, b)));
}

// Rows {x, y, z, -} of floats in every block of r0 to r3, to {x0, x1, x2, x3} in every block.
template <class D>
HWY_INLINE Pack<D> columns_of(D d, hn::Vec<D> r0, hn::Vec<D> r1, hn::Vec<D> r2, hn::Vec<D> r3) {
    const auto xy01 = hn::InterleaveLower(d, r0, r1), xy23 = hn::InterleaveLower(d, r2, r3);
    const auto z01 = hn::InterleaveUpper(d, r0, r1), z23 = hn::InterleaveUpper(d, r2, r3);
    return {lower_pairs(d, xy01, xy23), upper_pairs(d, xy01, xy23), lower_pairs(d, z01, z23)};
}

// Rows {x, y, z, -} of floats: one a lane, from rows + places[lane].
template <class D>
HWY_INLINE Pack<D> gather_rows(D d, const float* HWY_RESTRICT rows,
                               const std::uint32_t* HWY_RESTRICT places) {
    const auto at = [&](int lane) HWY_ATTR { return rows + places[lane]; };
    const auto blocks = [&](int j) HWY_ATTR {
#if HWY_TARGET == HWY_AVX3
        __m512 r = _mm512_castps128_ps512(_mm_load_ps(at(j)));
        r = _mm512_mask_broadcast_f32x4(r, 0x00F0, _mm_load_ps(at(j + 4)));
        r = _mm512_mask_broadcast_f32x4(r, 0x0F00, _mm_load_ps(at(j + 8)));
        return hn::Vec<D>{_mm512_mask_broadcast_f32x4(r, 0xF000, _mm_load_ps(at(j + 12)))};
#elif HWY_TARGET == HWY_AVX2
        const hn::Half<D> half;
        return hn::Combine(d, hn::Load(half, at(j + 4)), hn::Load(half, at(j)));
#else
        return hn::Load(d, at(j));
#endif
    };
    return columns_of(d, blocks(0), blocks(1), blocks(2), blocks(3));
}

// The same of doubles.
template <class D>
HWY_INLINE Pack<D> gather_rows(D d, const double* HWY_RESTRICT rows,
                               const std::uint32_t* HWY_RESTRICT places) {
    const auto at = [&](int lane) HWY_ATTR { return rows + places[lane]; };
#if HWY_TARGET == HWY_SSE4
    const auto a = hn::Load(d, at(0)), b = hn::Load(d, at(1));
    return {hn::InterleaveLower(d, a, b), hn::InterleaveUpper(d, a, b),
            hn::InterleaveLower(d, hn::Load(d, at(0) + 2), hn::Load(d, at(1) + 2))};
#else
#if HWY_TARGET == HWY_AVX3
    const auto two = [&](int j, int k) HWY_ATTR {
        return hn::Vec<D>{_mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(at(j))),
                                             _mm256_load_pd(at(k)), 1)};
    };
    const auto r0 = two(0, 2), r1 = two(1, 3), r2 = two(4, 6), r3 = two(5, 7);
#else
    const auto r0 = hn::Load(d, at(0)), r1 = hn::Load(d, at(1));
    const auto r2 = hn::Load(d, at(2)), r3 = hn::Load(d, at(3));
#endif
    const auto xz01 = hn::InterleaveLower(d, r0, r1), xz23 = hn::InterleaveLower(d, r2, r3);
    const auto y01 = hn::InterleaveUpper(d, r0, r1), y23 = hn::InterleaveUpper(d, r2, r3);
    return {even_blocks(d, xz01, xz23), even_blocks(d, y01, y23), odd_blocks(d, xz01, xz23)};
#endif
}

#if HWY_TARGET != HWY_SSE4
// Rows of particles, {x, y, z, -, vx, vy, vz, -}, of floats in whole registers.
template <class D>
HWY_INLINE Moving<D> gather_moving(D d, const float* HWY_RESTRICT rows,
                                   const std::uint32_t* HWY_RESTRICT places) {
    const auto at = [&](int lane) HWY_ATTR { return rows + places[lane]; };
#if HWY_TARGET == HWY_AVX3
    const auto r = [&](int j) HWY_ATTR {
        return hn::Vec<D>{_mm512_insertf32x8(_mm512_castps256_ps512(_mm256_load_ps(at(j))),
                                             _mm256_load_ps(at(j + 4)), 1)};
    };
    constexpr int half = 8;
#else
    const auto r = [&](int j) HWY_ATTR { return hn::Load(d, at(j)); };
    constexpr int half = 4;
#endif
    const Pack<D> a = columns_of(d, r(0), r(1), r(2), r(3));
    const Pack<D> b = columns_of(d, r(half), r(half + 1), r(half + 2), r(half + 3));
    return {{even_blocks(d, a.x, b.x), even_blocks(d, a.y, b.y), even_blocks(d, a.z, b.z)},
            {odd_blocks(d, a.x, b.x), odd_blocks(d, a.y, b.y), odd_blocks(d, a.z, b.z)}};
}
#endif

#if HWY_TARGET == HWY_AVX3
// The same of doubles: every row is a register.
template <class D>
HWY_INLINE Moving<D> gather_moving(D d, const double* HWY_RESTRICT rows,
                                   const std::uint32_t* HWY_RESTRICT places) {
    const auto r = [&](int lane) HWY_ATTR { return hn::Load(d, rows + places[lane]); };
    const auto r0 = r(0), r1 = r(1), r2 = r(2), r3 = r(3);
    const auto r4 = r(4), r5 = r(5), r6 = r(6), r7 = r(7);
    // Pairs of lanes a block: {x, z, vx, vz}, and {y, -, vy, -}.
    const auto xz01 = hn::InterleaveLower(d, r0, r1), xz23 = hn::InterleaveLower(d, r2, r3);
    const auto xz45 = hn::InterleaveLower(d, r4, r5), xz67 = hn::InterleaveLower(d, r6, r7);
    const auto y01 = hn::InterleaveUpper(d, r0, r1), y23 = hn::InterleaveUpper(d, r2, r3);
    const auto y45 = hn::InterleaveUpper(d, r4, r5), y67 = hn::InterleaveUpper(d, r6, r7);
    const auto x03 = even_blocks(d, xz01, xz23), x47 = even_blocks(d, xz45, xz67);
    const auto z03 = odd_blocks(d, xz01, xz23), z47 = odd_blocks(d, xz45, xz67);
    const auto y03 = even_blocks(d, y01, y23), y47 = even_blocks(d, y45, y67);
    return {{even_blocks(d, x03, x47), even_blocks(d, y03, y47), even_blocks(d, z03, z47)},
            {odd_blocks(d, x03, x47), odd_blocks(d, y03, y47), odd_blocks(d, z03, z47)}};
}
#else
// Where a row takes two registers or more, its halves are read apart.
template <class D, typename T>
HWY_INLINE Moving<D> gather_moving(D d, const T* HWY_RESTRICT rows,
                                   const std::uint32_t* HWY_RESTRICT places) {
    return {gather_rows(d, rows, places), gather_rows(d, rows + 4, places)};
}
#endif

// Writes rows {x, y, z, 0} of floats, lane after lane, `size` places apart.
template <int size, class D>
HWY_INLINE void store_rows(D d, const Pack<D>& p, float* HWY_RESTRICT rows) {
    const auto zero = hn::Zero(d);
    const auto xy01 = hn::InterleaveLower(d, p.x, p.y), xy23 = hn::InterleaveUpper(d, p.x, p.y);
    const auto z01 = hn::InterleaveLower(d, p.z, zero), z23 = hn::InterleaveUpper(d, p.z, zero);
    const hn::Vec<D> r[4] = {lower_pairs(d, xy01, z01), upper_pairs(d, xy01, z01),
                             lower_pairs(d, xy23, z23), upper_pairs(d, xy23, z23)};
    for (int j = 0; j < 4; ++j) {
        float* const to = rows + size * j;
#if HWY_TARGET == HWY_AVX3
        _mm_store_ps(to, _mm512_castps512_ps128(r[j].raw));
        _mm_store_ps(to + 4 * size, _mm512_extractf32x4_ps(r[j].raw, 1));
        _mm_store_ps(to + 8 * size, _mm512_extractf32x4_ps(r[j].raw, 2));
        _mm_store_ps(to + 12 * size, _mm512_extractf32x4_ps(r[j].raw, 3));
#elif HWY_TARGET == HWY_AVX2
        const hn::Half<D> half;
        hn::Store(hn::LowerHalf(r[j]), half, to);
        hn::Store(hn::UpperHalf(half, r[j]), half, to + 4 * size);
#else
        hn::Store(r[j], d, to);
#endif
    }
}

// The same of doubles.
template <int size, class D>
HWY_INLINE void store_rows(D d, const Pack<D>& p, double* HWY_RESTRICT rows) {
    const auto zero = hn::Zero(d);
    const hn::Vec<D> xy[2] = {hn::InterleaveLower(d, p.x, p.y), hn::InterleaveUpper(d, p.x, p.y)};
    const hn::Vec<D> z[2] = {hn::InterleaveLower(d, p.z, zero), hn::InterleaveUpper(d, p.z, zero)};
    for (int j = 0; j < 2; ++j) {
        double* const to = rows + size * j;
#if HWY_TARGET == HWY_AVX3
        _mm_store_pd(to, _mm512_castpd512_pd128(xy[j].raw));
        _mm_store_pd(to + 2, _mm512_castpd512_pd128(z[j].raw));
        _mm_store_pd(to + 2 * size, _mm512_extractf64x2_pd(xy[j].raw, 1));
        _mm_store_pd(to + 2 * size + 2, _mm512_extractf64x2_pd(z[j].raw, 1));
        _mm_store_pd(to + 4 * size, _mm512_extractf64x2_pd(xy[j].raw, 2));
        _mm_store_pd(to + 4 * size + 2, _mm512_extractf64x2_pd(z[j].raw, 2));
        _mm_store_pd(to + 6 * size, _mm512_extractf64x2_pd(xy[j].raw, 3));
        _mm_store_pd(to + 6 * size + 2, _mm512_extractf64x2_pd(z[j].raw, 3));
#elif HWY_TARGET == HWY_AVX2
        hn::Store(even_blocks(d, xy[j], z[j]), d, to);
        hn::Store(odd_blocks(d, xy[j], z[j]), d, to + 2 * size);
#else
        hn::Store(xy[j], d, to);
        hn::Store(z[j], d, to + 2);
#endif
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
