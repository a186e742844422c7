// The sheet of the comparison's tables, with what they leave out: mass and damping.
#pragma once

#include <string>

#include "weft/scene.h"

namespace weft::lab {

inline constexpr double seed_time_step = 0.016;  ///< that the comparison's table 1 implies [s]
inline constexpr double seed_stiffness = 800.0;  ///< of every spring [N/m]

/// What the comparison does not print.
struct SeedSheet {
    double particle_mass = 1.0;  ///< [kg]
    double drag_rate = 0.0;      ///< c / m of the drag on every particle [1/s]
    double dashpot_time = 0.0;   ///< c / k of every spring [s]
};

/// 40 x 40 particles, 20 m x 20 m, lying, every spring of 800 N/m, gravity, both top corners held.
SceneDescription seed_scene(const SeedSheet& sheet);

/// Energy that the sheet sets free where it swings down without stretching: its weight times half
/// its height [J].
double fall_energy(const SeedSheet& sheet);

/// "1 kg, undamped", "0.03 kg, drag 0.5 /s, dashpots c = 2 ms k".
std::string describe(const SeedSheet& sheet);

}  // namespace weft::lab
