// Text, numbers and files as they stand in an HTML page.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/byte_order.h"
#include "lab/section.h"

namespace weft::lab {

/// `text` with &, <, >, " and ' escaped and control characters left out: for elements and
/// attributes.
std::string html(std::string_view text);

/// The same, with what stands between backquotes as <code>.
std::string html_with_code(std::string_view text);

/// A number for reading, with that many significant digits: "1.20", "250000",
/// "1.2&times;10<sup>&minus;5</sup>". Whole numbers below a million are shown whole; a number
/// that is rounded keeps its zeros.
std::string html_number(double value, int digits);

/// A number for attributes and files: the shortest text that reads back as the same double; "inf",
/// "-inf", "nan".
std::string exact_number(double value);

/// The file's bytes as "data:TYPE;base64,...".
std::string data_uri(std::string_view type, const Bytes& bytes);

}  // namespace weft::lab
