// A cloth's shape as text, short enough that a hundred of them can be kept.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "weft/vec3.h"

namespace weft::lab {

/// Positions of particles [m].
using Shape = std::vector<Vec3d>;

/// The box around the positions, then three characters a co-ordinate: its place in the box, in
/// 2^18 parts. What is read back is within the box's side / 2^19 of what was written.
/// @pre every co-ordinate is finite.
std::string shape_to_text(std::span<const Vec3d> positions);

/// @throws Error (file) where the text is no shape.
Shape shape_from_text(std::string_view text);

}  // namespace weft::lab
