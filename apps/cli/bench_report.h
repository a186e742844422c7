// How what `weft bench` found is shown: a line of the table a row, or one JSON object.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bench/suite/suite.h"

namespace weft {

/// What the machine can do, a few lines.
std::string machine_text(const bench::Machine& machine);
/// The table's head, and a line of it, both ending in a newline.
std::string bench_table_head();
std::string bench_table_line(const bench::Row& row);

/// What every element of "rows" begins with: "case", "columns", "rows", "precision", "threads".
nlohmann::ordered_json label_json(const bench::Label& label);
/// An element of "rows" (docs/cli.md). A row has null where a column does not apply.
nlohmann::ordered_json row_json(const bench::Row& row);
/// "machine".
nlohmann::ordered_json machine_json(const bench::Machine& machine);

}  // namespace weft
