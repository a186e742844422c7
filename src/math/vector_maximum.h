// How long the longest of weighted sums of vectors is: what control of the error asks of a step.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <span>

#include "math/instruction_sets.h"
#include "math/vec3_array.h"

namespace weft {

/// For two sums of the same arrays of vectors, S_k = sum_i weights_ki in_i, the square of
///     the largest of |S_1|, |S_2|, each over max(1, sqrt(|w_1 u_1|^2 + |w_2 u_2|^2))
/// at one place. The divisor, of up to two other arrays u, may be left out.
template <typename Real>
class VectorMaximum {
public:
    static constexpr std::size_t max_inputs = 8, block = 4096;

    /// How much memory compute() wants for arrays of `size` vectors.
    static constexpr std::size_t block_count(std::size_t size) {
        return (size + block - 1) / block;
    }

    /// Adds an input and its weights in the two sums; one that counts in neither is left out.
    VectorMaximum& add(const Vec3Array<Real>& input, double first, double second = 0.0) {
        if (first == 0.0 && second == 0.0) return *this;
        assert(input_count_ < max_inputs);
        inputs_[input_count_] = input.view();
        weights_[input_count_] = {static_cast<Real>(first), static_cast<Real>(second)};
        ++input_count_;
        return *this;
    }
    /// Divides by these arrays, weighted.
    VectorMaximum& over(const Vec3Array<Real>& first, double first_weight,
                        const Vec3Array<Real>& second, double second_weight) {
        divisors_ = {first.view(), second.view()};
        divisor_weights_ = {static_cast<Real>(first_weight), static_cast<Real>(second_weight)};
        has_divisor_ = true;
        return *this;
    }

    /// In parallel where that pays; the same bits for any number of threads.
    /// @param maxima [block_count], overwritten.
    /// @return infinity where a sum is not finite.
    double compute(InstructionSet set, std::span<double> maxima) const;

    // What kernels read.
    [[nodiscard]] std::size_t size() const { return inputs_[0].size; }
    [[nodiscard]] std::size_t input_count() const { return input_count_; }
    [[nodiscard]] const ConstVec3View<Real>& input(std::size_t i) const { return inputs_[i]; }
    [[nodiscard]] Real weight(std::size_t sum, std::size_t i) const { return weights_[i][sum]; }
    [[nodiscard]] bool has_divisor() const { return has_divisor_; }
    [[nodiscard]] const ConstVec3View<Real>& divisor(std::size_t i) const { return divisors_[i]; }
    [[nodiscard]] Real divisor_weight(std::size_t i) const { return divisor_weights_[i]; }

private:
    std::size_t input_count_ = 0;
    std::array<ConstVec3View<Real>, max_inputs> inputs_{};
    std::array<std::array<Real, 2>, max_inputs> weights_{};
    bool has_divisor_ = false;
    std::array<ConstVec3View<Real>, 2> divisors_{};
    std::array<Real, 2> divisor_weights_{};
};

extern template class VectorMaximum<float>;
extern template class VectorMaximum<double>;

}  // namespace weft
