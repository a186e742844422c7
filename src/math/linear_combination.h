// Linear combinations of arrays: what an integrator does between evaluations of the forces.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

#include "math/instruction_sets.h"
#include "math/vec3_array.h"

namespace weft {

/// One or two arrays as weighted sums of the same arrays,
///     out_k = sum_i weights_ki in_i,
/// each read once. An output may be one of the inputs.
template <typename Real>
class LinearCombination {
public:
    static constexpr std::size_t max_inputs = 8, max_outputs = 2;

    /// @param outputs all of one size.
    explicit LinearCombination(Vec3Array<Real>& output) : outputs_{&output, nullptr} {}
    LinearCombination(Vec3Array<Real>& first, Vec3Array<Real>& second)
        : outputs_{&first, &second} {}

    /// Adds an input and its weights in the two outputs; one that counts in neither is left out.
    LinearCombination& add(const Vec3Array<Real>& input, double first, double second = 0.0) {
        if (first == 0.0 && second == 0.0) return *this;
        assert(input_count_ < max_inputs && input.data_size() == outputs_[0]->data_size());
        inputs_[input_count_] = input.data();
        weights_[0][input_count_] = static_cast<Real>(first);
        weights_[1][input_count_] = static_cast<Real>(second);
        ++input_count_;
        return *this;
    }

    /// Computes the outputs, in parallel where that pays. The same bits for any number of threads.
    void compute(InstructionSet set) const;

    [[nodiscard]] std::size_t input_count() const { return input_count_; }
    [[nodiscard]] std::size_t output_count() const { return outputs_[1] != nullptr ? 2 : 1; }
    [[nodiscard]] const Real* input(std::size_t i) const { return inputs_[i]; }
    [[nodiscard]] Real weight(std::size_t output, std::size_t i) const {
        return weights_[output][i];
    }
    [[nodiscard]] Real* output(std::size_t k) const { return outputs_[k]->data(); }

private:
    std::array<Vec3Array<Real>*, max_outputs> outputs_;
    std::size_t input_count_ = 0;
    std::array<const Real*, max_inputs> inputs_{};
    std::array<std::array<Real, max_inputs>, max_outputs> weights_{};
};

extern template class LinearCombination<float>;
extern template class LinearCombination<double>;

}  // namespace weft
