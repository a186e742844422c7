// A reference solution that shares nothing with the methods ranked: the extrapolated midpoint rule.
#pragma once

#include <cstddef>

#include "lab/trajectory.h"

namespace weft::lab {

/// What a reference solution is, and how far it can be trusted.
struct Reference {
    ParticleState<double> state;
    double error = 0.0;           ///< estimated: rms distance to the same at 10 tolerances [m]
    std::size_t evaluations = 0;  ///< of the forces, for `state`
    std::size_t steps = 0;        ///< taken for it
    bool converged = false;       ///< both reached t_end, and every step met the tolerance
};

/// The state at t_end from `start`, by Gragg's, Bulirsch's and Stoer's extrapolation with control
/// of step and order (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.9).
/// Only accelerations of the forces are shared with the methods. No step goes past a kink of the
/// scene (kinks.h). Where a step would have to be shorter than time resolves, it ends early, not
/// converged.
/// @pre t_end >= start.time.
/// @param tolerance > 0 of the rms error of a step, positions and velocities taken together [m] and
///        [m/s x 1 s]; what rounding hides is allowed for.
Reference reference_solution(Specimen& specimen, const ParticleState<double>& start, double t_end,
                             double tolerance, const Watch& watch);

}  // namespace weft::lab
