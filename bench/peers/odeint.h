// Boost.odeint on the sheet, in double: its steppers with the textbook's force loop as the
// right-hand side.
#pragma once

#include <memory>
#include <string>

#include "bench/peers/plain_sheet.h"

namespace weft::bench {

enum class OdeintStepper {
    rk4,
    velocity_verlet  ///< gives the forces v at half the step: not weft's formula where damped
};

/// Only where Boost was found when this was built.
std::unique_ptr<SteppedPeer> make_odeint(const PlainSheet& sheet, OdeintStepper stepper);

/// Boost's, e.g. "1.74.0".
std::string odeint_version();

}  // namespace weft::bench
