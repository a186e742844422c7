// Compiled for every instruction set.
#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "math/ritz_pass.cpp"  // NOLINT
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "math/ritz_pass.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE double sum_of(D d, hn::Vec<D> lanes) {
    return static_cast<double>(hn::GetLane(hn::SumOfLanes(d, lanes)));
}

// The sums of one block, in every lane its own.
template <class D>
struct LaneSums {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(D());
    V xx = zero, xp = zero, xr = zero, pp = zero, pr = zero, rr = zero;
    V x_ax = zero, x_ap = zero, x_ar = zero, p_ap = zero, p_ar = zero;

    HWY_INLINE LaneSums() {}  // NOLINT: one that is compiled for the instruction set

    // r.Ax and r.Ap stand for x.Ar and p.Ar: A is symmetric.
    HWY_INLINE void add(V x, V p, V r, V ax, V ap) {
        xx = hn::MulAdd(x, x, xx), xp = hn::MulAdd(x, p, xp), xr = hn::MulAdd(x, r, xr);
        pp = hn::MulAdd(p, p, pp), pr = hn::MulAdd(p, r, pr), rr = hn::MulAdd(r, r, rr);
        x_ax = hn::MulAdd(x, ax, x_ax), x_ap = hn::MulAdd(x, ap, x_ap);
        x_ar = hn::MulAdd(r, ax, x_ar), p_ap = hn::MulAdd(p, ap, p_ap);
        p_ar = hn::MulAdd(r, ap, p_ar);
    }
    HWY_INLINE RitzSums sums() const {
        const D d;
        return {sum_of(d, xx),   sum_of(d, xp),   sum_of(d, xr),   sum_of(d, pp),
                sum_of(d, pr),   sum_of(d, rr),   sum_of(d, x_ax), sum_of(d, x_ap),
                sum_of(d, x_ar), sum_of(d, p_ap), sum_of(d, p_ar)};
    }
};

template <typename Real>
HWY_INLINE void ritz_blocks(const RitzPass<Real>& pass, std::size_t begin, std::size_t end) {
    using D = hn::ScalableTag<Real>;
    const D d;
    const auto c_x = hn::Set(d, pass.direction_x), c_p = hn::Set(d, pass.direction_p),
               c_r = hn::Set(d, pass.direction_r), c = hn::Set(d, pass.vector_x),
               value = hn::Set(d, pass.value);
    for (std::size_t n = begin; n < end; ++n) {
        const std::size_t first = n * pass.block;
        const std::size_t last = first + pass.block < pass.size ? first + pass.block : pass.size;
        LaneSums<D> sums;
        for (std::size_t i = first; i < last; i += hn::Lanes(d)) {
            const auto x = hn::Load(d, pass.x + i), ax = hn::Load(d, pass.ax + i);
            const auto p = hn::MulAdd(c_r, hn::Load(d, pass.r + i),
                                      hn::MulAdd(c_p, hn::Load(d, pass.p + i), hn::Mul(c_x, x)));
            const auto ap = hn::MulAdd(c_r, hn::Load(d, pass.ar + i),
                                       hn::MulAdd(c_p, hn::Load(d, pass.ap + i), hn::Mul(c_x, ax)));
            const auto next = hn::MulAdd(c, x, p), a_next = hn::MulAdd(c, ax, ap);
            const auto r = hn::NegMulAdd(value, next, a_next);
            sums.add(next, p, r, a_next, ap);
            hn::Store(next, d, pass.x + i);
            hn::Store(p, d, pass.p + i);
            hn::Store(r, d, pass.r + i);
            hn::Store(a_next, d, pass.ax + i);
            hn::Store(ap, d, pass.ap + i);
        }
        pass.sums[n] = sums.sums();
    }
}

void ritz_pass_single(const RitzPass<float>& pass, std::size_t begin, std::size_t end) {
    ritz_blocks(pass, begin, end);
}
void ritz_pass_double(const RitzPass<double>& pass, std::size_t begin, std::size_t end) {
    ritz_blocks(pass, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace weft {

namespace {

// The readable twin.
template <typename Real>
void plain_ritz_pass(const RitzPass<Real>& pass, std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
        RitzSums sums;
        for (std::size_t i = n * pass.block; i < (n + 1) * pass.block && i < pass.size; ++i) {
            const Real p = pass.direction_x * pass.x[i] + pass.direction_p * pass.p[i] +
                           pass.direction_r * pass.r[i];
            const Real ap = pass.direction_x * pass.ax[i] + pass.direction_p * pass.ap[i] +
                            pass.direction_r * pass.ar[i];
            const Real x = pass.vector_x * pass.x[i] + p, ax = pass.vector_x * pass.ax[i] + ap;
            const Real r = ax - pass.value * x;
            pass.x[i] = x, pass.p[i] = p, pass.r[i] = r, pass.ax[i] = ax, pass.ap[i] = ap;
            const double dx = x, dp = p, dr = r, dax = ax, dap = ap;
            sums += {dx * dx,  dx * dp,  dx * dr,  dp * dp,  dp * dr, dr * dr,
                     dx * dax, dx * dap, dr * dax, dp * dap, dr * dap};
        }
        pass.sums[n] = sums;
    }
}

}  // namespace

RitzSums& RitzSums::operator+=(const RitzSums& other) {
    xx += other.xx, xp += other.xp, xr += other.xr;
    pp += other.pp, pr += other.pr, rr += other.rr;
    x_ax += other.x_ax, x_ap += other.x_ap, x_ar += other.x_ar;
    p_ap += other.p_ap, p_ar += other.p_ar;
    return *this;
}

RitzFunction<float> ritz_pass_single(InstructionSet set) {
    if (set == InstructionSet::scalar) return plain_ritz_pass<float>;
    return WEFT_SIMD_FUNCTION(set, ritz_pass_single);
}
RitzFunction<double> ritz_pass_double(InstructionSet set) {
    if (set == InstructionSet::scalar) return plain_ritz_pass<double>;
    return WEFT_SIMD_FUNCTION(set, ritz_pass_double);
}

}  // namespace weft
#endif
