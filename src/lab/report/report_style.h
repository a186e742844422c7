// The report's style sheet and script.
#pragma once

#include <string>
#include <string_view>

namespace weft::lab {

/// CSS: light and dark, a phone's width, print. Colours of lines are those of plot_colours().
std::string page_style();

/// JavaScript: tables are sorted by their headings; the contents show where the reader is. The page
/// can be read without it.
std::string_view page_script();

}  // namespace weft::lab
