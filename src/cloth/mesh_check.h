// What a polygon mesh must be before anything is built from it, and how messages number its parts.
#pragma once

#include <cstddef>
#include <string>

#include "weft/scene.h"

namespace weft {

/// The number that a user knows vertex `vertex` of the mesh by: as its file counts.
std::size_t vertex_number(const Mesh& mesh, std::size_t vertex);

/// The number that a user knows face `face` of the mesh by: as its file counts, so that the
/// triangles cut from one polygon share a number.
std::size_t face_number(const Mesh& mesh, std::size_t face);

/// @param file names the mesh in errors.
/// @throws Error (file) where the mesh has no faces, a face has other than 3 or 4 corners, an index
///         is out of range, or a co-ordinate is not finite or beyond 1e9 m.
void check_mesh(const Mesh& mesh, const std::string& file);

}  // namespace weft
