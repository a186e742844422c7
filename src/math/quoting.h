// Text of unknown content, made fit for a message of one line.
#pragma once

#include <string>
#include <string_view>

namespace weft {

/// The text with every control character replaced by a space.
std::string one_line(std::string_view text);

/// The text in double quotes as a TOML string: quotes, backslashes and control characters escaped.
std::string in_quotes(std::string_view text);

}  // namespace weft
