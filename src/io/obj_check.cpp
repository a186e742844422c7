#include "io/obj_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/printable.h"
#include "weft/error.h"

namespace weft {

namespace {

constexpr std::string_view blanks = " \t";

/// A line of the file, for messages.
struct Line {
    const std::string& file;
    int number;

    [[nodiscard]] Error error(const std::string& message) const {
        return {ErrorKind::file, {.file = file, .line = number}, message};
    }
};

/// Takes the next word off the front of `text`; empty at its end.
std::string_view take_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

void check_number(std::string_view word, const Line& line) {
    const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
    double value = 0.0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (status == std::errc::invalid_argument || end != digits.data() + digits.size())
        throw line.error(fmt::format("{} is not a number", printable(word)));
    if (status != std::errc{} || !std::isfinite(value))
        throw line.error(fmt::format("{} is not a finite number", printable(word)));
}

/// At least `least` numbers, and nothing else.
void check_numbers(std::string_view words, std::size_t least, const Line& line) {
    std::size_t count = 0;
    for (auto word = take_word(words); !word.empty(); word = take_word(words), ++count)
        check_number(word, line);
    if (count < least)
        throw line.error(
            fmt::format("{} numbers stand here: at least {} are needed", count, least));
}

bool is_index(std::string_view word) {
    int value = 0;
    const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
    return status == std::errc{} && end == word.data() + word.size() && value != 0;
}

/// v, v/vt, v//vn or v/vt/vn.
bool is_corner(std::string_view word) {
    const std::size_t slash = word.find('/');
    if (!is_index(word.substr(0, slash))) return false;
    if (slash == std::string_view::npos) return true;
    const std::string_view rest = word.substr(slash + 1);
    const std::size_t second = rest.find('/');
    if (second == std::string_view::npos) return is_index(rest);
    return (second == 0 || is_index(rest.substr(0, second))) && is_index(rest.substr(second + 1));
}

void check_corners(std::string_view words, const Line& line) {
    std::size_t count = 0;
    for (auto word = take_word(words); !word.empty(); word = take_word(words), ++count)
        if (!is_corner(word))
            throw line.error(
                fmt::format("{} is not a face corner: v, v/vt, v//vn or v/vt/vn with "
                            "whole numbers other than 0 are allowed",
                            printable(word)));
    if (count < 3)
        throw line.error(fmt::format("the face has {} corners: at least 3 are needed", count));
}

void check_line(std::string_view text, const Line& line) {
    const std::string_view keyword = take_word(text);
    if (keyword == "v") check_numbers(text, 3, line);
    if (keyword == "vt") check_numbers(text, 1, line);
    if (keyword == "f") check_corners(text, line);
}

std::size_t end_of_line(std::string_view text, std::size_t from) {
    return std::min(text.find_first_of("\r\n", from), text.size());
}

std::size_t next_line(std::string_view text, std::size_t end) {
    const bool two = text.substr(end, 2) == "\r\n";
    return std::min(end + (two ? 2 : 1), text.size());
}

/// Blanks out the comment of the line [begin, end), and joins to it the lines that continue it.
/// @return the end of the joined line, and how many lines were added.
std::pair<std::size_t, int> join_line(std::string& text, std::size_t begin, std::size_t end) {
    int added = 0;
    for (std::size_t from = begin;; ++added) {
        const auto line_end = text.begin() + static_cast<std::ptrdiff_t>(end);
        std::fill(std::find(text.begin() + static_cast<std::ptrdiff_t>(from), line_end, '#'),
                  line_end, ' ');
        if (end == from || text[end - 1] != '\\' || end == text.size()) return {end, added};
        from = next_line(text, end);
        std::fill(text.begin() + static_cast<std::ptrdiff_t>(end - 1),
                  text.begin() + static_cast<std::ptrdiff_t>(from), ' ');
        end = end_of_line(text, from);
    }
}

}  // namespace

void check_obj(std::string& text, const std::string& file) {
    if (text.find('\0') != std::string::npos)
        throw file_error(file, "not an OBJ file: it holds zero bytes");
    int number = 1;
    for (std::size_t begin = 0; begin < text.size(); ++number) {
        const auto [end, added] = join_line(text, begin, end_of_line(text, begin));
        check_line(std::string_view(text).substr(begin, end - begin), {file, number});
        number += added;
        begin = next_line(text, end);
    }
}

}  // namespace weft
