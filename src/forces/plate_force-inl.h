// The force of the air on a flat plate (forces/plate_force.h), a plate in every lane, for the
// instruction set being compiled; included once for each.
#if defined(WEFT_FORCES_PLATE_FORCE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_PLATE_FORCE_INL_H
#undef WEFT_FORCES_PLATE_FORCE_INL_H
#else
#define WEFT_FORCES_PLATE_FORCE_INL_H
#endif

#include <hwy/highway.h>

#include "forces/plate_force.h"
#include "math/pack-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

/// plate_force_third() on triangles of normal N, where v_sum is the sum of their corners'
/// velocities. A triangle without area, or without relative wind, has none.
template <class D, typename T>
HWY_INLINE Pack<D> plate_third(D d, const AirConstants<T>& air, const Vec3<T>& wind,
                               const Pack<D>& normal, const Pack<D>& v_sum) {
    const auto relative = minus_scaled(set(d, wind), hn::Set(d, T(1.0 / 3.0)), v_sum);
    const auto normal_squared = square(d, normal);
    const auto inverse_area = inverse_root(d, normal_squared);  // 1 / (2 A)
    const auto speed_squared = square(d, relative);
    const auto speed = hn::Mul(speed_squared, inverse_root(d, speed_squared));
    const auto v_n = hn::Mul(dot(relative, normal), inverse_area);
    const auto v_t = minus_scaled(relative, hn::Mul(v_n, inverse_area), normal);
    const auto slip_squared = square(d, v_t);
    const auto slip = hn::Mul(slip_squared, inverse_root(d, slip_squared));
    const auto resistance =
        hn::MulAdd(hn::Set(d, T(0.222)), hn::Abs(v_n), hn::Mul(hn::Set(d, T(0.283)), speed));
    const auto across = hn::Div(
        hn::Mul(hn::Set(d, T(1.0 / 3.0) * air.normal), hn::Mul(speed_squared, v_n)), resistance);
    const auto along = hn::Mul(hn::Mul(hn::Set(d, T(1.0 / 3.0) * air.tangential), slip),
                               hn::Mul(normal_squared, inverse_area));
    return plus_scaled(times(across, normal), along, v_t);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
