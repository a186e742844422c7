// The order of convergence that a set of errors shows.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace weft::lab {

struct ErrorAtStep {
    double step = 0.0;   ///< [s]
    double error = 0.0;  ///< in any unit
};

/// A line through log(error) over log(step).
struct OrderFit {
    double order = 0.0;  ///< its slope, by least squares; not finite where no fit is
    double smallest = 0.0, largest = 0.0;  ///< steps it was taken over [s]
    std::size_t points = 0;
    bool straight = false;  ///< the slopes between neighbours differ by straight_within at most

    /// "2.5e-04 to 4.0e-03 s", or why there is no fit.
    [[nodiscard]] std::string range() const;
};

/// Slopes between neighbouring points of a straight range differ by no more than this.
inline constexpr double straight_within = 0.1;

/// The slope over the range in which it is straight: of all runs of at least four neighbouring
/// points (three, where no four are straight) it takes the one with the shortest steps, and in it
/// as many points as are straight. Where nothing is straight, over all usable points, which
/// `straight` then tells.
/// @param errors by falling step; those not finite, not positive or below `floor` are not used.
/// @param floor below which an error is the reference's or rounding's.
OrderFit fit_order(std::span<const ErrorAtStep> errors, double floor);

}  // namespace weft::lab
