#include "math/linear_combination.h"

#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "math/linear_combination.cpp"  // NOLINT
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "math/simd-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// Elements [begin, end), a multiple of the longest vector's.
template <std::size_t inputs, std::size_t outputs, typename Real>
HWY_NOINLINE void combine_counted(const LinearCombination<Real>& sum, std::size_t begin,
                                  std::size_t end) {
    const hn::ScalableTag<Real> d;
    using V = hn::Vec<decltype(d)>;
    V weights[outputs][inputs];
    const Real* in[inputs];
    Real* out[outputs];
    for (std::size_t i = 0; i < inputs; ++i) {
        in[i] = sum.input(i);
        for (std::size_t k = 0; k < outputs; ++k) weights[k][i] = hn::Set(d, sum.weight(k, i));
    }
    for (std::size_t k = 0; k < outputs; ++k) out[k] = sum.output(k);
    for (std::size_t n = begin; n < end; n += hn::Lanes(d)) {
        V total[outputs];
        const V first = hn::Load(d, in[0] + n);
        for (std::size_t k = 0; k < outputs; ++k) total[k] = hn::Mul(weights[k][0], first);
        for (std::size_t i = 1; i < inputs; ++i) {
            const V value = hn::Load(d, in[i] + n);
            for (std::size_t k = 0; k < outputs; ++k) {
                total[k] = hn::MulAdd(weights[k][i], value, total[k]);
            }
        }
        for (std::size_t k = 0; k < outputs; ++k) hn::Store(total[k], d, out[k] + n);
    }
}

template <std::size_t inputs, typename Real>
HWY_INLINE void combine_inputs(const LinearCombination<Real>& sum, std::size_t begin,
                               std::size_t end) {
    if (sum.output_count() == 1) {
        combine_counted<inputs, 1>(sum, begin, end);
    } else {
        combine_counted<inputs, 2>(sum, begin, end);
    }
}

template <typename Real>
HWY_INLINE void combine(const LinearCombination<Real>& sum, std::size_t begin, std::size_t end) {
    switch (sum.input_count()) {
        case 1:
            return combine_inputs<1>(sum, begin, end);
        case 2:
            return combine_inputs<2>(sum, begin, end);
        case 3:
            return combine_inputs<3>(sum, begin, end);
        case 4:
            return combine_inputs<4>(sum, begin, end);
        case 5:
            return combine_inputs<5>(sum, begin, end);
        case 6:
            return combine_inputs<6>(sum, begin, end);
        case 7:
            return combine_inputs<7>(sum, begin, end);
        default:
            return combine_inputs<8>(sum, begin, end);
    }
}

void combine_single(const LinearCombination<float>& sum, std::size_t begin, std::size_t end) {
    combine(sum, begin, end);
}
void combine_double(const LinearCombination<double>& sum, std::size_t begin, std::size_t end) {
    combine(sum, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#if HWY_ONCE
#include "math/parallel.h"

namespace weft {

namespace {

// The readable twin.
template <typename Real>
void combine_scalar(const LinearCombination<Real>& sum, std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
        std::array<Real, LinearCombination<Real>::max_outputs> total{};
        for (std::size_t k = 0; k < sum.output_count(); ++k) {
            for (std::size_t i = 0; i < sum.input_count(); ++i) {
                total[k] += sum.weight(k, i) * sum.input(i)[n];
            }
        }
        for (std::size_t k = 0; k < sum.output_count(); ++k) sum.output(k)[n] = total[k];
    }
}

template <typename Real>
using CombineFunction = void (*)(const LinearCombination<Real>&, std::size_t, std::size_t);

CombineFunction<float> function_for(float, InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, combine_single);
}
CombineFunction<double> function_for(double, InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, combine_double);
}

}  // namespace

template <typename Real>
void LinearCombination<Real>::compute(InstructionSet set) const {
    constexpr std::size_t line = 64 / sizeof(Real);  // arrays are whole cache lines
    constexpr std::size_t grain = 4096;  // lines; below, waking a thread costs more than the loop
    CombineFunction<Real> function = function_for(Real{}, set);
    if (function == nullptr) function = combine_scalar<Real>;
    parallel_for(outputs_[0]->data_size() / line, grain, [&](std::size_t begin, std::size_t end) {
        function(*this, begin * line, end * line);
    });
}

template class LinearCombination<float>;
template class LinearCombination<double>;

}  // namespace weft
#endif  // HWY_ONCE
