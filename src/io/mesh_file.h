// Polygon meshes from OBJ and PLY files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "weft/scene.h"

namespace weft {

/// Reads an OBJ or PLY file (by its ending): positions, faces, texture co-ordinates, in the order
/// of the file. Faces with more than four corners are cut into triangles from their first corner
/// (Mesh::source_faces then says which they were). Texture co-ordinates are kept where every corner
/// has them: in OBJ those of the faces, in PLY those of the vertices (s and t, or u and v). PLY
/// positions are read in single precision.
/// @throws Error (file) naming the file and what is wrong: not readable, larger than 2 GiB, another
///         ending, malformed (with the line), no faces, an index out of range, a co-ordinate that
///         is not finite.
Mesh load_mesh(const std::filesystem::path& path);

}  // namespace weft
