// The scenes that weft is timed on.
#pragma once

#include <cstdint>
#include <string_view>

#include "bench/peers/plain_sheet.h"
#include "weft/scene.h"

namespace weft::bench {

/// How a scene is stepped. A frame is `steps_per_frame` steps long: weft looks for divergence and
/// keeps a copy of the state once a frame, which is then a small part of the time.
struct Stepping {
    std::string_view method = "symplectic-euler";
    Precision precision = Precision::f32;
    int steps_per_frame = 100;
};

/// Step of every timed sheet [s]: half of the limit of forward Euler on it, the lowest of all.
inline constexpr double sheet_step = 5e-5;

/// The sheet as a grid, particle for particle.
SceneDescription sheet_scene(const PlainSheet& sheet, const Stepping& stepping);

/// The sheet at weft's own step for 60 frames a second, for comparing time and motion by the frame.
SceneDescription sheet_at_60_hertz(const PlainSheet& sheet);

/// The same sheet as a mesh of quads whose vertices and faces stand in random order.
SceneDescription mesh_scene(const PlainSheet& sheet, const Stepping& stepping,
                            std::uint64_t seed = 1);

/// The shipped flag at another resolution, in its wind or in none.
SceneDescription flag_scene(int columns, int rows, bool wind, const Stepping& stepping);

}  // namespace weft::bench
