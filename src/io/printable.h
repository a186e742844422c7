// Words of a file fit for a message.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace weft {

/// The word with every byte that is not plain ASCII print as '?', cut to 40 bytes: what stands in a
/// broken file must not reach the terminal as it is.
inline std::string printable(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text(word.substr(0, longest));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return word.size() > longest ? text + "..." : text;
}

}  // namespace weft
