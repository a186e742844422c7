// One sweep of LargestEigenvalue over its arrays: the next vector, direction and residual with
// their images, and every scalar product that the step after will ask for. Arrays are taken as
// ranges of numbers, in blocks of one size that are summed in order: threads do not change results.
#pragma once

#include <array>
#include <cstddef>

#include "math/instruction_sets.h"

namespace weft {

/// Scalar products of the vector x, direction p and residual r with each other and the images.
struct RitzSums {
    double xx = 0, xp = 0, xr = 0, pp = 0, pr = 0, rr = 0;
    double x_ax = 0, x_ap = 0, x_ar = 0, p_ap = 0, p_ar = 0;

    RitzSums& operator+=(const RitzSums& other);
};

/// direction = c_x x + c_p p + c_r r, vector = c x + direction, the same with the images; then
/// residual = image - value vector.
template <typename Real>
struct RitzPass {
    static constexpr std::size_t block = 1024;  ///< numbers that are summed together

    Real *x = nullptr, *p = nullptr, *r = nullptr, *ax = nullptr, *ap = nullptr;
    const Real* ar = nullptr;
    std::size_t size = 0;  ///< of each, whole cache lines
    Real direction_x = 0, direction_p = 0, direction_r = 0;
    Real vector_x = 0;
    Real value = 0;
    RitzSums* sums = nullptr;  ///< [block]

    [[nodiscard]] std::size_t blocks() const { return (size + block - 1) / block; }
};

/// Runs the pass over blocks [begin, end).
template <typename Real>
using RitzFunction = void (*)(const RitzPass<Real>&, std::size_t begin, std::size_t end);

/// The function compiled for an instruction set; for scalar, plain loops.
RitzFunction<float> ritz_pass_single(InstructionSet set);
RitzFunction<double> ritz_pass_double(InstructionSet set);

}  // namespace weft
