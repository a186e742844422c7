// Wavefront OBJ: the mesh that goes with point caches, and the frames of an OBJ sequence.
#pragma once

#include <span>
#include <string_view>

#include "io/output_file.h"
#include "weft/frame.h"

namespace weft {

/// Writes a whole OBJ: a v line for every particle (so its order is that of the point caches), a vt
/// line for every surface vertex, quads and triangles. Numbers read back to the same floats.
/// @param comment   goes into the head of the file; lines must start with '#'.
/// @param positions [particle], [m]
/// @param normals   [particle], unit; empty: none are written
/// @throws Error (file).
void write_obj(OutputFile& file, std::string_view comment, const Surface& surface,
               std::span<const Vec3d> positions, std::span<const Vec3f> normals);

}  // namespace weft
