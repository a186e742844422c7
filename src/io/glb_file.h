// Binary glTF recordings read back.
#pragma once

#include <filesystem>
#include <memory>

#include "io/recording_file.h"

namespace weft {

/// Opens a glb with one mesh of triangles and, where it moves, a linear or stepwise animation of
/// its morph targets; weft's own and similar ones of other programs. Vertices in one place become
/// one particle. Positions are the mesh's own: node transforms are not applied.
/// @throws Error (file).
std::unique_ptr<RecordedMotion> open_glb(const std::filesystem::path& path);

}  // namespace weft
