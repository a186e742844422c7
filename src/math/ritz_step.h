// The small problem of an iteration of LargestEigenvalue: the best vector in a span of three.
#pragma once

#include <array>

#include "math/ritz_pass.h"

namespace weft {

/// What a RitzPass does: direction = direction_x x + direction_p p + direction_r r and
/// vector = vector_x x + direction.
struct RitzStep {
    double direction_x = 0, direction_p = 0, direction_r = 0;
    double vector_x = 1;
    double value = 0;  ///< the new vector's Rayleigh quotient
};

/// The step to the unit vector of the largest Rayleigh quotient in the span of x, r and p; its
/// direction is the part orthogonal to x.
/// @param r_ar r.Ar
/// @param noise a part of p or r is left out if, squared, less than this part of it is outside the
///        span of those before.
RitzStep ritz_step(const RitzSums& sums, double r_ar, double noise);

/// Estimates from the gains of the last iterations how much there is to be gained.
class RemainingGain {
public:
    void add(double gain);

    /// Of a geometric series that goes on as the last three gains do; infinity before.
    [[nodiscard]] double remaining() const;

private:
    std::array<double, 3> last_{-1, -1, -1};
};

}  // namespace weft
