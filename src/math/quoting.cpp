#include "math/quoting.h"

#include <fmt/format.h>

namespace weft {

namespace {

bool is_control(char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 || code == 0x7f;
}

}  // namespace

std::string one_line(std::string_view text) {
    std::string line(text);
    for (char& c : line) {
        if (is_control(c)) c = ' ';
    }
    return line;
}

std::string in_quotes(std::string_view text) {
    std::string line = "\"";
    for (const char c : text) {
        if (is_control(c)) {
            line += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
            continue;
        }
        if (c == '"' || c == '\\') line += '\\';
        line += c;
    }
    return line + "\"";
}

}  // namespace weft
