// Where weft's own data files are.
#pragma once

#include <filesystem>

namespace weft {

/// The directory that holds scenes/: $WEFT_DATA_DIR where that is set; else the first that exists
/// of
/// ../share/weft beside the running program, the source tree weft was built from, and the
/// directory weft was to be installed in.
/// @throws Error (file) naming the places looked at.
std::filesystem::path data_directory();

}  // namespace weft
