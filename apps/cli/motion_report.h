// How the accuracy of motion is shown by `weft bench`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bench/suite/motion.h"

namespace weft {

/// The table's head, and a line of it, both ending in a newline.
std::string motion_table_head(const bench::MotionReference& reference);
std::string motion_table_line(const bench::MotionRow& row);

/// An element of "rows" (docs/cli.md).
nlohmann::ordered_json motion_json(const bench::MotionRow& row,
                                   const bench::MotionReference& reference);

}  // namespace weft
