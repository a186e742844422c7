// What kernels need beyond Highway 1.0.3, for the instruction set being compiled (see
// math/simd_targets.h): a shift across whole vectors and exact reciprocal roots. Included once for
// each set, hence no #pragma once.
#if defined(WEFT_MATH_SIMD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_MATH_SIMD_INL_H
#undef WEFT_MATH_SIMD_INL_H
#else
#define WEFT_MATH_SIMD_INL_H
#endif

#include <hwy/highway.h>

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Lane l of the result is lane l - n of `current`, or, where l < n, of `previous` from its end:
/// the vectors joined and moved n lanes up.
template <int n, class D, class V>
HWY_INLINE V shift_in(D d, V current, V previous) {
    using T = hn::TFromD<D>;
#if HWY_TARGET == HWY_AVX3
    // Highway's shifts stay within blocks of 128 bits; one instruction does it for the whole.
    (void)d;
    if constexpr (sizeof(T) == 4) {
        return V{_mm512_castsi512_ps(_mm512_alignr_epi32(
            _mm512_castps_si512(current.raw), _mm512_castps_si512(previous.raw), 16 - n))};
    } else {
        return V{_mm512_castsi512_pd(_mm512_alignr_epi64(
            _mm512_castpd_si512(current.raw), _mm512_castpd_si512(previous.raw), 8 - n))};
    }
#else
    constexpr int block = 16;  // bytes
    constexpr int bytes = block - n * static_cast<int>(sizeof(T));
    const hn::Repartition<std::uint8_t, D> du8;
#if HWY_TARGET == HWY_AVX2
    const V below = hn::ConcatLowerUpper(d, current, previous);
#else
    const V below = previous;
#endif
    if constexpr (bytes == 0) {
        return below;
    } else {
        return hn::BitCast(d, hn::CombineShiftRightBytes<bytes>(du8, hn::BitCast(du8, current),
                                                                hn::BitCast(du8, below)));
    }
#endif
}

/// root_scale / sqrt(s), to within three units in the last place. s > 0, and in float s below
/// 1e38 and above 1e-37.
template <class D, class V>
HWY_INLINE V scaled_inverse_root(D d, V s) {
    using T = hn::TFromD<D>;
    if constexpr (sizeof(T) == 4) {
        // Newton's step on an estimate y of 11 bits at least: 2 / sqrt(s) = y (3 - s y^2).
        const V y = hn::ApproximateReciprocalSqrt(s);
        return hn::Mul(y, hn::NegMulAdd(hn::Mul(s, y), y, hn::Set(d, T{3})));
    } else {
#if HWY_TARGET == HWY_AVX3
        // An estimate y of 14 bits, and with e = 1 - s y^2 the series
        // 1 / sqrt(1 - e) = 1 + e/2 + 3/8 e^2 + 5/16 e^3 + O(e^4): 53 bits in one step.
        const V y{_mm512_rsqrt14_pd(s.raw)};
        const V e = hn::NegMulAdd(hn::Mul(s, y), y, hn::Set(d, 1.0));
        V series = hn::MulAdd(e, hn::Set(d, 0.3125), hn::Set(d, 0.375));
        series = hn::MulAdd(series, e, hn::Set(d, 0.5));
        return hn::MulAdd(series, hn::Mul(y, e), y);
#else
        return hn::Div(hn::Set(d, 1.0), hn::Sqrt(s));
#endif
    }
}

/// 1 / sqrt(s); as scaled_inverse_root().
template <class D, class V>
HWY_INLINE V inverse_root(D d, V s) {
    using T = hn::TFromD<D>;
    const V scaled = scaled_inverse_root(d, s);
    return root_scale<T> == T{1} ? scaled : hn::Mul(scaled, hn::Set(d, 1 / root_scale<T>));
}

/// What is added to a squared length, so that a spring without length has a finite root and, its
/// direction being zero, no force.
template <typename T>
inline constexpr T least_square = sizeof(T) == 4 ? T(1e-30) : T(1e-200);

/// Three vectors: the components of one 3-D vector a lane.
template <class D>
struct Pack {
    hn::Vec<D> x, y, z;
};

template <class D>
HWY_INLINE Pack<D> load_pack(D d, const hn::TFromD<D>* x, const hn::TFromD<D>* y,
                             const hn::TFromD<D>* z) {
    return {hn::LoadU(d, x), hn::LoadU(d, y), hn::LoadU(d, z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
