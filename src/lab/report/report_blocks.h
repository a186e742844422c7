// Paragraphs, figures and tables of the report as HTML.
#pragma once

#include <filesystem>
#include <string>

#include "lab/report/report_layout.h"

namespace weft::lab {

/// `text` in <p> elements: an empty line ends one. `code` stands between backquotes.
std::string paragraphs_html(const std::string& text);

/// A sortable table in a box of its own that scrolls.
/// @param number of the table, in its caption; 0: none.
std::string table_html(const Table& table, const std::string& anchor, int number);

/// A block; pictures and videos are read and put into the page.
/// @param directory of the report.
/// @throws Error (file) where a picture or video cannot be read, or is of no known type.
std::string block_html(const PlacedBlock& placed, const std::filesystem::path& directory);

}  // namespace weft::lab
