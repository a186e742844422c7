// The scenes that weft is timed on.
#pragma once

#include <cstdint>
#include <optional>
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

/// The sheet at 60 frames a second, for comparing time and motion by the frame.
/// @param time_step [s]; none: weft's own for the method.
SceneDescription sheet_at_60_hertz(const PlainSheet& sheet, std::string_view method,
                                   std::optional<double> time_step = {});

/// A sheet of 1 m x 1 m and 0.2 kg that others can make as well: structural and shear springs of
/// 1000 N/m each at every resolution, bend springs of a thousandth, no dashpots; with enough drag
/// to hang still after two seconds.
PlainSheet hanging_sheet(int size);

/// The same sheet as a mesh of quads whose vertices and faces stand in random order.
SceneDescription mesh_scene(const PlainSheet& sheet, const Stepping& stepping,
                            std::uint64_t seed = 1);

/// The shipped flag at another resolution, in its wind or in none.
SceneDescription flag_scene(int columns, int rows, bool wind, const Stepping& stepping);

}  // namespace weft::bench
