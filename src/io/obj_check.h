// Makes sure that an OBJ file is one before a library reads it.
#pragma once

#include <string>

namespace weft {

/// Checks every line that positions, texture co-ordinates and faces come from (v, vt, f): numbers
/// that are numbers and finite, corners as v, v/vt, v//vn or v/vt/vn with whole numbers other than
/// 0. The library would take anything else for zero. Other lines are let be.
///
/// Comments and the marks that continue a line on the next become spaces in `text`.
/// @param file names the file in errors.
/// @throws Error (file) with the line.
void check_obj(std::string& text, const std::string& file);

}  // namespace weft
