// Static equilibrium: where all forces on a cloth balance.
#pragma once

#include "integrators/dynamics_system.h"
#include "weft/simulation.h"

namespace weft {

struct SettleLimits {
    double relative_residual = 1e-6;  ///< of the mean weight of a particle
    int max_iterations = 2000;        ///< of Newton
};

/// Moves x [slot] to a state of rest at time t by pseudo-transient continuation (Kelley, Keyes
/// 1998): implicit Euler steps that forget their velocity, each longer than the last. Short ones
/// lead through buckling, where the static problem has no unique way; in the longest inertia no
/// longer counts, and what Newton solves is the static problem.
/// @param weight mean weight of a free particle [N]; 0 where there is no gravity: the first largest
///        unbalanced force counts in its place.
SettleReport settle(ImplicitSystem& system, double t, double weight, const SettleLimits& limits,
                    Vec3Array<double>& x);

}  // namespace weft
