// Arithmetic of packs, a 3-D vector in every lane, for the instruction set being compiled; included
// once for each.
#if defined(WEFT_MATH_PACK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_MATH_PACK_INL_H
#undef WEFT_MATH_PACK_INL_H
#else
#define WEFT_MATH_PACK_INL_H
#endif

#include <hwy/highway.h>

#include "math/simd-inl.h"
#include "weft/vec3.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

template <class D>
HWY_INLINE Pack<D> zero_pack(D d) {
    return {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
}
/// The same vector in every lane.
template <class D, typename T>
HWY_INLINE Pack<D> set(D d, const Vec3<T>& a) {
    return {hn::Set(d, a.x), hn::Set(d, a.y), hn::Set(d, a.z)};
}
template <class D>
HWY_INLINE Pack<D> minus(const Pack<D>& a, const Pack<D>& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class D>
HWY_INLINE Pack<D> plus(const Pack<D>& a, const Pack<D>& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
template <class D>
HWY_INLINE Pack<D> times(const hn::Vec<D>& s, const Pack<D>& a) {
    return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}
/// a + s b
template <class D>
HWY_INLINE Pack<D> plus_scaled(const Pack<D>& a, const hn::Vec<D>& s, const Pack<D>& b) {
    return {hn::MulAdd(s, b.x, a.x), hn::MulAdd(s, b.y, a.y), hn::MulAdd(s, b.z, a.z)};
}
/// a - s b
template <class D>
HWY_INLINE Pack<D> minus_scaled(const Pack<D>& a, const hn::Vec<D>& s, const Pack<D>& b) {
    return {hn::NegMulAdd(s, b.x, a.x), hn::NegMulAdd(s, b.y, a.y), hn::NegMulAdd(s, b.z, a.z)};
}
template <class D>
HWY_INLINE Pack<D> cross(const Pack<D>& a, const Pack<D>& b) {
    return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)), hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
            hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}
template <class D>
HWY_INLINE hn::Vec<D> dot(const Pack<D>& a, const Pack<D>& b) {
    return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}
/// a.a, and a little more than zero
template <class D>
HWY_INLINE hn::Vec<D> square(D d, const Pack<D>& a) {
    using T = hn::TFromD<D>;
    return hn::MulAdd(a.z, a.z,
                      hn::MulAdd(a.y, a.y, hn::MulAdd(a.x, a.x, hn::Set(d, least_square<T>))));
}
/// Every component's lanes moved up by n (shift_in).
template <int n, class D>
HWY_INLINE Pack<D> shift_in(D d, const Pack<D>& current, const Pack<D>& previous) {
    return {shift_in<n>(d, current.x, previous.x), shift_in<n>(d, current.y, previous.y),
            shift_in<n>(d, current.z, previous.z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
