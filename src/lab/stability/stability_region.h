// Where in the complex plane a method is stable, traced from its amplification.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "simulation/stability.h"

namespace weft::lab {

/// A point z = lambda dt of the complex plane: real part, imaginary part.
using PlanePoint = std::array<double, 2>;

/// The boundary of the region about 0 in which a mode of z = lambda dt does not grow, as a step
/// that is made longer reaches it: on each ray from 0, the first z beyond which it grows. The left
/// half plane from the imaginary axis over the negative real axis to the imaginary axis below. Rays
/// on which nothing ends the region up to `most` end there.
/// @param rays in each quadrant, at least 2.
std::vector<PlanePoint> stability_boundary(std::string_view method, int rays, double most = 20.0);

/// lambda dt of a mode: a pair mirrored at the real axis, or two real values where it is
/// overdamped.
std::array<PlanePoint, 2> eigenvalues(const Mode& mode, double time_step);

/// The growth a step of an undamped mode, against omega dt from `first` to `last`, evenly in its
/// logarithm.
std::vector<PlanePoint> growth_on_imaginary_axis(std::string_view method, double first, double last,
                                                 int points);
/// The same of a critically damped one, z = -omega dt.
std::vector<PlanePoint> growth_on_real_axis(std::string_view method, double first, double last,
                                            int points);

}  // namespace weft::lab
