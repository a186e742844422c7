// How many floating-point operations a step takes at least: the basis of GFLOP/s.
#pragma once

#include <string_view>

#include "bench/peers/plain_sheet.h"

namespace weft::bench {

/// Operations of one spring, counted once for both its ends. Additions, multiplications and a
/// reciprocal square root are one each; what a kernel spends on refining an approximate root, on
/// masks, or on computing a spring twice is not counted.
///     d = x_q - x_p                              3
///     s = d.d                                    5
///     y = 1 / sqrt(s)                            1
///     g = k - (k L) y                            2
///     with a dashpot:
///       w = v_q - v_p                            3
///       g = g + c (w.d) y y                      5 + 3 + 1
///     f = g d                                    3
///     f_p = f_p + f, f_q = f_q - f               6
/// So 20 without a dashpot, 32 with one.
constexpr double flops_per_spring(bool damped) {
    return damped ? 32.0 : 20.0;
}

/// Operations of one particle for each evaluation of the forces:
///     f = f - c v                                6
///     a = g + f / m                              6
///     a multiply-add into v and one into x      12
/// Methods of several stages combine more than that; the rest is not counted.
constexpr double flops_per_particle = 24.0;

/// Of a whole step of the sheet: the above for every evaluation of the method. 216 for a particle
/// in the middle of a damped sheet and a method of one evaluation.
double flops_per_step(const PlainSheet& sheet, int evaluations);

}  // namespace weft::bench
