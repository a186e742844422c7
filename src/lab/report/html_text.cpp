#include "lab/report/html_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace weft::lab {

namespace {

constexpr const char* minus = "&minus;";

// "-1.5" with a proper minus sign.
std::string with_minus(const std::string& digits) {
    return digits.starts_with('-') ? minus + digits.substr(1) : digits;
}

// "1.2e-05" as 1.2 times a power of ten.
std::string with_power(const std::string& scientific) {
    const std::size_t e = scientific.find('e');
    const int power = std::stoi(scientific.substr(e + 1));
    return fmt::format("{}&times;10<sup>{}{}</sup>", with_minus(scientific.substr(0, e)),
                       power < 0 ? minus : "", std::abs(power));
}

}  // namespace

std::string html(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                if (static_cast<unsigned char>(c) >= ' ' && c != '\x7f') result += c;
                if (c == '\n' || c == '\t') result += c;
        }
    }
    return result;
}

std::string html_with_code(std::string_view text) {
    std::string result;
    while (true) {
        const std::size_t begin = text.find('`');
        const std::size_t end = begin == std::string_view::npos ? begin : text.find('`', begin + 1);
        if (end == std::string_view::npos) return result + html(text);
        result += html(text.substr(0, begin));
        result += "<code>" + html(text.substr(begin + 1, end - begin - 1)) + "</code>";
        text.remove_prefix(end + 1);
    }
}

std::string html_number(double value, int digits) {
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return value > 0.0 ? "&infin;" : std::string(minus) + "&infin;";
    if (value == 0.0) return "0";
    const double size = std::abs(value);
    const bool whole = size < 1e6 && value == std::round(value);
    if (whole || (size < 1e6 && size >= std::pow(10.0, digits) - 0.5)) {
        return with_minus(fmt::format("{:.0f}", value));
    }
    const std::string shortest = fmt::format("{:.{}g}", value, digits);
    const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
    const bool exact = std::strtod(shortest.c_str(), nullptr) == value;
    if (shortest.find('e') != std::string::npos) return with_power(exact ? shortest : scientific);
    if (exact) return with_minus(shortest);
    // What is rounded keeps its zeros: 2.00 was measured, 2 is exact.
    const int power = std::stoi(scientific.substr(scientific.find('e') + 1));
    return with_minus(fmt::format("{:.{}f}", value, std::max(0, digits - 1 - power)));
}

std::string exact_number(double value) {
    if (std::isnan(value)) return "nan";
    return fmt::format("{}", value);
}

std::string data_uri(std::string_view type, const Bytes& bytes) {
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result = fmt::format("data:{};base64,", type);
    result.reserve(result.size() + (bytes.size() + 2) / 3 * 4);
    for (std::size_t n = 0; n < bytes.size(); n += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group <<= 8U;
            if (n + k < bytes.size()) group |= static_cast<unsigned>(bytes[n + k]);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const bool there = n + k <= bytes.size();
            result += there ? letters[(group >> (18 - 6 * k)) & 63U] : '=';
        }
    }
    return result;
}

}  // namespace weft::lab
