// The frequencies of a cloth at rest: a few dozen that stand for all, from a Lanczos process.
#pragma once

#include <cstddef>
#include <vector>

#include "lab/laboratory.h"
#include "lab/trajectory.h"

namespace weft::lab {

/// Ritz values: eigenvalues of M^-1/2 K M^-1/2 seen through a Krylov space. They spread over the
/// whole spectrum; the largest and the smallest are eigenvalues to many digits, those between stand
/// for the crowd around them.
struct Spectrum {
    std::vector<Mode> modes;  ///< by rising omega; damping rate as the Rayleigh quotient of C
    bool complete = false;    ///< the process ended by itself: every frequency there is, once
};

/// The springs linearised at `state`, as StabilityAnalysis has them: compressed springs without
/// their negative part, air and gravity left out.
/// @param count of Ritz values, at most; fewer where memory (128 MB of vectors) or the cloth allows
///        no more.
/// @throws Interrupted.
Spectrum ritz_spectrum(const Specimen& specimen, const ParticleState<double>& state,
                       std::size_t count, const Watch& watch);

}  // namespace weft::lab
