// Makes sure that a PLY file is whole before a library reads it.
#pragma once

#include <string>
#include <string_view>

namespace weft {

/// Checks the header of a PLY file (ascii, binary_little_endian or binary_big_endian) and walks
/// through its body, so that every declared element, list and number is there. The library would
/// read past what is missing, and make room for whatever a count says.
/// @param file names the file in errors.
/// @return the same mesh as a PLY file of just the elements vertex and face, in this order, with a
///         plain header in which properties that make no cloth have the name "other".
/// @throws Error (file), with the line for ascii files.
std::string check_ply(std::string_view bytes, const std::string& file);

}  // namespace weft
