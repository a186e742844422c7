#include "lab/shape_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "weft/error.h"

namespace weft::lab {

namespace {

constexpr std::string_view digits =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz-_";
constexpr std::uint32_t parts = (1u << 18) - 1;

[[noreturn]] void refuse() {
    throw file_error("a kept trial", "a shape in it cannot be read");
}

double take_number(std::string_view& text) {
    const std::size_t end = text.find(' ');
    if (end == std::string_view::npos) refuse();
    double value = 0.0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + end, value);
    if (error != std::errc{} || stop != text.data() + end) refuse();
    text.remove_prefix(end + 1);
    return value;
}

std::uint32_t digit_of(char c) {
    const std::size_t place = digits.find(c);
    if (place == std::string_view::npos) refuse();
    return static_cast<std::uint32_t>(place);
}

std::array<double, 3> components(Vec3d x) {
    return {x.x, x.y, x.z};
}

}  // namespace

std::string shape_to_text(std::span<const Vec3d> positions) {
    constexpr double most = std::numeric_limits<double>::max();
    std::array<double, 3> low{most, most, most}, high{-most, -most, -most};
    for (const Vec3d& x : positions) {
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], components(x)[c]);
            high[c] = std::max(high[c], components(x)[c]);
        }
    }
    std::string text;
    for (std::size_t c = 0; c < 3; ++c) text += fmt::format("{} {} ", low[c], high[c] - low[c]);
    text.reserve(text.size() + 9 * positions.size());
    for (const Vec3d& x : positions) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double side = high[c] - low[c];
            const double place = side > 0.0 ? (components(x)[c] - low[c]) / side : 0.0;
            const auto part = static_cast<std::uint32_t>(std::lround(place * parts));
            for (const unsigned shift : {12u, 6u, 0u}) text += digits[part >> shift & 63u];
        }
    }
    return text;
}

Shape shape_from_text(std::string_view text) {
    std::array<double, 3> low{}, side{};
    for (std::size_t c = 0; c < 3; ++c) {
        low[c] = take_number(text);
        side[c] = take_number(text);
    }
    if (text.size() % 9 != 0) refuse();
    Shape shape;
    shape.reserve(text.size() / 9);
    for (std::size_t n = 0; n < text.size(); n += 9) {
        std::array<double, 3> x{};
        for (std::size_t c = 0; c < 3; ++c) {
            std::uint32_t part = 0;
            for (std::size_t d = 0; d < 3; ++d) part = part << 6u | digit_of(text[n + 3 * c + d]);
            x[c] = low[c] + side[c] * part / parts;
        }
        shape.push_back({x[0], x[1], x[2]});
    }
    return shape;
}

}  // namespace weft::lab
