// Compiled for every instruction set.
#include "math/vector_maximum.h"

#include <limits>

#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "math/vector_maximum.cpp"  // NOLINT
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "math/simd-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

template <class D>
struct LaneVectors {
    using V = hn::Vec<D>;
    V x = hn::Zero(D()), y = hn::Zero(D()), z = hn::Zero(D());

    HWY_INLINE LaneVectors() {}  // NOLINT: one that is compiled for the instruction set
    HWY_INLINE void add(V weight, V in_x, V in_y, V in_z) {
        x = hn::MulAdd(weight, in_x, x);
        y = hn::MulAdd(weight, in_y, y);
        z = hn::MulAdd(weight, in_z, z);
    }
    HWY_INLINE V squared() const { return hn::MulAdd(z, z, hn::MulAdd(y, y, hn::Mul(x, x))); }
};

// Vectors of the block, and zeros behind the last.
template <typename Real>
HWY_INLINE double block_maximum(const VectorMaximum<Real>& sums, std::size_t begin,
                                std::size_t end) {
    using D = hn::ScalableTag<Real>;
    const D d;
    const auto one = hn::Set(d, Real{1}), zero = hn::Zero(d);
    auto top = zero, odd = zero;  // odd: 0, or not a number
    for (std::size_t n = begin; n < end; n += hn::Lanes(d)) {
        LaneVectors<D> first, second;
        for (std::size_t i = 0; i < sums.input_count(); ++i) {
            const auto& in = sums.input(i);
            const auto x = hn::Load(d, in.x + n), y = hn::Load(d, in.y + n),
                       z = hn::Load(d, in.z + n);
            first.add(hn::Set(d, sums.weight(0, i)), x, y, z);
            second.add(hn::Set(d, sums.weight(1, i)), x, y, z);
        }
        auto longest = hn::Max(first.squared(), second.squared());
        odd = hn::MulAdd(zero, hn::Add(first.squared(), second.squared()), odd);
        if (sums.has_divisor()) {
            auto divisor = zero;
            for (std::size_t i = 0; i < 2; ++i) {
                const auto& by = sums.divisor(i);
                LaneVectors<D> scaled;
                scaled.add(hn::Set(d, sums.divisor_weight(i)), hn::Load(d, by.x + n),
                           hn::Load(d, by.y + n), hn::Load(d, by.z + n));
                divisor = hn::Add(divisor, scaled.squared());
            }
            longest = hn::Div(longest, hn::Max(one, divisor));
        }
        top = hn::Max(top, longest);
    }
    const bool finite = hn::GetLane(hn::SumOfLanes(d, odd)) == 0;
    return finite ? static_cast<double>(hn::GetLane(hn::MaxOfLanes(d, top)))
                  : std::numeric_limits<double>::infinity();
}

double maximum_single(const VectorMaximum<float>& sums, std::size_t begin, std::size_t end) {
    return block_maximum(sums, begin, end);
}
double maximum_double(const VectorMaximum<double>& sums, std::size_t begin, std::size_t end) {
    return block_maximum(sums, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#if HWY_ONCE
#include <algorithm>
#include <cmath>
#include <limits>

#include "math/parallel.h"

namespace weft {

namespace {

template <typename Real>
Real squared(Vec3<Real> v) {
    return dot(v, v);
}

// The readable twin.
template <typename Real>
double maximum_scalar(const VectorMaximum<Real>& sums, std::size_t begin, std::size_t end) {
    Real top = 0;
    for (std::size_t n = begin; n < end; ++n) {
        Vec3<Real> first{}, second{};
        for (std::size_t i = 0; i < sums.input_count(); ++i) {
            first += sums.weight(0, i) * sums.input(i)[n];
            second += sums.weight(1, i) * sums.input(i)[n];
        }
        const Real one = squared(first), other = squared(second);
        if (!std::isfinite(one + other)) return std::numeric_limits<double>::infinity();
        Real divisor = 0;
        for (std::size_t i = 0; sums.has_divisor() && i < 2; ++i) {
            divisor += squared(sums.divisor_weight(i) * sums.divisor(i)[n]);
        }
        top = std::max(top, std::max(one, other) / std::max(Real{1}, divisor));
    }
    return static_cast<double>(top);
}

template <typename Real>
using MaximumFunction = double (*)(const VectorMaximum<Real>&, std::size_t, std::size_t);

MaximumFunction<float> function_for(float, InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, maximum_single);
}
MaximumFunction<double> function_for(double, InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, maximum_double);
}

}  // namespace

template <typename Real>
double VectorMaximum<Real>::compute(InstructionSet set, std::span<double> maxima) const {
    constexpr std::size_t grain = 4;  // blocks
    assert(input_count_ > 0 && maxima.size() == block_count(size()));
    MaximumFunction<Real> function = function_for(Real{}, set);
    if (function == nullptr) function = maximum_scalar<Real>;
    parallel_for(maxima.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            maxima[b] = function(*this, b * block, std::min(size(), (b + 1) * block));
        }
    });
    return maxima.empty() ? 0.0 : *std::max_element(maxima.begin(), maxima.end());
}

template class VectorMaximum<float>;
template class VectorMaximum<double>;

}  // namespace weft
#endif  // HWY_ONCE
