// Inverse factors of diagonal blocks (math/block_pass.h), for the instruction set being compiled;
// included once for each. In double: blocks of stiff springs and light masses are as ill
// conditioned as float has digits.
#if defined(WEFT_MATH_BLOCK_FACTOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_MATH_BLOCK_FACTOR_INL_H
#undef WEFT_MATH_BLOCK_FACTOR_INL_H
#else
#define WEFT_MATH_BLOCK_FACTOR_INL_H
#endif

#include <hwy/highway.h>

#include "math/block_pass.h"
#include "math/simd-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// Floats as doubles: half as many lanes as the set has of floats.
struct BlockSum {
    using D = hn::ScalableTag<double>;
    using F = hn::Rebind<float, D>;
    using V = hn::Vec<D>;
    V xx, xy, xz, yy, yz, zz;

    static HWY_INLINE V number(const float* group, std::size_t n) {
        return hn::PromoteTo(D(), hn::Load(F(), group + n * block_lanes));
    }
    static HWY_INLINE BlockSum load(const float* block) {
        return {number(block, 0), number(block, 1), number(block, 2),
                number(block, 3), number(block, 4), number(block, 5)};
    }
    HWY_INLINE void add(const BlockSum& o) {
        xx = hn::Add(xx, o.xx), xy = hn::Add(xy, o.xy), xz = hn::Add(xz, o.xz);
        yy = hn::Add(yy, o.yy), yz = hn::Add(yz, o.yz), zz = hn::Add(zz, o.zz);
    }
    // + a I + g g^T
    HWY_INLINE void add_spring(const float* spring) {
        const V x = number(spring, 1), y = number(spring, 2), z = number(spring, 3);
        add_diagonal(number(spring, 0));
        xx = hn::MulAdd(x, x, xx), xy = hn::MulAdd(x, y, xy), xz = hn::MulAdd(x, z, xz);
        yy = hn::MulAdd(y, y, yy), yz = hn::MulAdd(y, z, yz), zz = hn::MulAdd(z, z, zz);
    }
    HWY_INLINE void add_diagonal(V a) {
        xx = hn::Add(xx, a), yy = hn::Add(yy, a), zz = hn::Add(zz, a);
    }
    [[nodiscard]] HWY_INLINE V trace() const { return hn::Add(xx, hn::Add(yy, zz)); }
    HWY_INLINE void store(float* block) const {
        const V numbers[] = {xx, xy, xz, yy, yz, zz};
        for (std::size_t n = 0; n < 6; ++n) {
            hn::Store(hn::DemoteTo(F(), numbers[n]), F(), block + n * block_lanes);
        }
    }
};

// W, lower triangular, with W^T W = A^-1: the inverse of Cholesky's factor. Pivots that rounding
// makes too small or negative are raised. Zero for a block of zero.
HWY_INLINE BlockSum inverse_factor(const BlockSum& a) {
    const BlockSum::D d;
    const auto trace = a.trace();
    const auto least = hn::Mul(hn::Set(d, 1e-14), trace);
    const auto root = [&](BlockSum::V pivot) HWY_ATTR {
        const auto inverse = hn::Div(hn::Set(d, 1.0), hn::Sqrt(hn::Max(pivot, least)));
        return hn::IfThenElseZero(hn::Gt(trace, hn::Zero(d)), inverse);
    };
    BlockSum w;
    w.xx = root(a.xx);
    const auto l_yx = hn::Mul(a.xy, w.xx), l_zx = hn::Mul(a.xz, w.xx);
    w.yy = root(hn::NegMulAdd(l_yx, l_yx, a.yy));
    const auto l_zy = hn::Mul(hn::NegMulAdd(l_zx, l_yx, a.yz), w.yy);
    w.zz = root(hn::NegMulAdd(l_zy, l_zy, hn::NegMulAdd(l_zx, l_zx, a.zz)));
    w.xy = hn::Neg(hn::Mul(hn::Mul(l_yx, w.xx), w.yy));
    w.yz = hn::Neg(hn::Mul(hn::Mul(l_zy, w.yy), w.zz));
    w.xz = hn::Neg(hn::Mul(hn::MulAdd(l_zx, w.xx, hn::Mul(l_zy, w.xy)), w.zz));
    return w;
}

// The diagonal blocks of one vector of rows.
HWY_INLINE void factor_rows(const BlockPass& pass, std::size_t slice, std::size_t lane) {
    const std::size_t size = static_cast<std::size_t>(pass.form) * block_lanes;
    const std::size_t place = 6 * block_lanes * slice + lane;
    BlockSum b = BlockSum::load(pass.own + place), sum = b;
    for (std::size_t n = pass.starts[slice]; n < pass.starts[slice + 1]; ++n) {
        const float* const coupling = pass.couplings + size * n + lane;
        if (pass.form == BlockForm::spring) {
            sum.add_spring(coupling);
        } else {
            sum.add(BlockSum::load(coupling));
        }
    }
    if (pass.weight != 0.0f) {
        const auto shift =
            hn::Mul(hn::Set(BlockSum::D(), static_cast<double>(pass.weight)), sum.trace());
        b.add_diagonal(shift);
        sum.add_diagonal(shift);
        b.store(pass.own_out + place);
    }
    inverse_factor(sum).store(pass.factors_out + place);
}

inline void factor(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for (std::size_t slice = begin * slices_per_block;
         slice < end * slices_per_block && slice < pass.slices; ++slice) {
        for (std::size_t lane = 0; lane < block_lanes; lane += hn::Lanes(BlockSum::D())) {
            factor_rows(pass, slice, lane);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
