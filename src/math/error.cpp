#include "weft/error.h"

#include <fmt/format.h>

#include <utility>

namespace weft {

namespace {

std::string one_line(const ErrorPlace& place, const std::string& message) {
    std::string line;
    if (!place.file.empty()) {
        line += place.file + ":";
        if (place.line > 0) line += fmt::format("{}:", place.line);
        if (place.line > 0 && place.column > 0) line += fmt::format("{}:", place.column);
        line += " ";
    }
    if (!place.key.empty()) line += place.key + ": ";
    return line + message;
}

}  // namespace

Error::Error(ErrorKind kind, ErrorPlace place, const std::string& message, std::string detail)
    : std::runtime_error(one_line(place, message)),
      kind_(kind),
      place_(std::move(place)),
      message_(message),
      detail_(std::move(detail)) {}

Error scene_error(const std::string& key, const std::string& value, const std::string& allowed) {
    return {ErrorKind::usage, {.key = key}, fmt::format("{} is not allowed: {}", value, allowed)};
}

Error file_error(const std::string& file, const std::string& reason, std::string detail) {
    return {ErrorKind::file, {.file = file}, reason, std::move(detail)};
}

}  // namespace weft
