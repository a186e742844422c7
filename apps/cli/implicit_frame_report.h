// How the implicit frames of `weft bench` are shown.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bench/suite/implicit_frame.h"

namespace weft {

/// The table's head, and a line of it, both ending in a newline.
std::string frame_table_head();
std::string frame_table_line(const bench::FrameRow& row);

/// An element of "rows" (docs/cli.md).
nlohmann::ordered_json frame_json(const bench::FrameRow& row);

}  // namespace weft
