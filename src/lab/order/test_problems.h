// Small problems on which the order of every method shows: one of known solution, and a smooth
// cloth with and without damping.
#pragma once

#include "lab/trajectory.h"
#include "weft/scene.h"

namespace weft::lab {

/// Two masses of 1 kg, each on a vertical spring of 25 N/m from a point that is held, falling from
/// where the spring has its length of 1 m: x'' = g - omega^2 x, harmonic to the last digit. (The
/// lowest row of a grid of 2 x 3 particles with bend springs alone; the two upper rows are held.)
SceneDescription hanging_masses();
inline constexpr double hanging_omega = 5.0;     ///< [1/s]
inline constexpr double hanging_end_time = 1.1;  ///< 5.5 radians: no multiple of a period [s]

/// Where the masses are at a time, exactly.
ParticleState<double> hanging_solution(const Specimen& hanging_masses, double time);

/// A sheet of 6 x 6 particles and 1 m in gravity, one corner held, one moved aside. Damped: with
/// dashpots and drag, and in a wind so strong that the air never meets a face edge-on or at rest,
/// where its force has a kink.
SceneDescription moving_sheet(bool damped);
inline constexpr double moving_end_time = 0.37;  ///< [s]; within one blend of gust and pin

}  // namespace weft::lab
