// Reading a text file whole.
#pragma once

#include <cstddef>
#include <string>

namespace weft {

/// @param limit refuses files beyond it [bytes].
/// @throws Error (file) with the path as given and the system's reason.
std::string read_text_file(const std::string& path, std::size_t limit);

}  // namespace weft
