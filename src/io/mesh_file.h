// Polygon meshes from OBJ and PLY files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "weft/scene.h"

namespace weft {

/// Reads an OBJ or PLY file (by its ending): positions, faces, texture co-ordinates. Faces with
/// more than four corners are cut into triangles from their first corner.
/// @throws Error (file) naming the file and what is wrong.
Mesh load_mesh(const std::filesystem::path& path);

}  // namespace weft
