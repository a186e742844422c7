// The state that a run begins with, as a NumPy file of shape (2, particles, 3): positions [m], then
// velocities [m/s].
#pragma once

#include <filesystem>

#include "io/output_file.h"
#include "weft/scene.h"

namespace weft {

/// Reads float64 or float32, little-endian, in C order.
/// @throws Error (file) naming the file and what is wrong: not readable, not such an array, cut
///         off or too long, a number that is not finite.
ClothState load_start_state(const std::filesystem::path& path);

/// Writes float64: every state, of single precision too, reads back to the bit.
/// @throws Error (file).
void write_start_state(OutputFile& file, const ClothState& state);

}  // namespace weft
