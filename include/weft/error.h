// The one exception type of weft. Building a scene and reading or writing files throw it; stepping
// does not (it reports, see simulation.h).
#pragma once

#include <stdexcept>
#include <string>

namespace weft {

/// What went wrong, and with it the exit status of the `weft` command.
enum class ErrorKind {
    diverged,  ///< the simulation diverged or could not go on (exit status 1)
    usage,     ///< the command line or the scene is wrong (exit status 2)
    file,      ///< reading or writing failed (exit status 3)
};

/// Where it went wrong; a part that does not apply is empty or zero.
struct ErrorPlace {
    std::string file{};  ///< path as the user gave it
    int line = 0;        ///< from 1; 0 where there is none
    int column = 0;      ///< from 1; 0 where there is none
    std::string key{};   ///< scene key in dotted form, e.g. "cloth.resolution"
};

/// An error with its place. what() is one line,
///     file:line:column: key: message
/// with the absent parts left out; detail() is further advice, empty or one or more lines.
class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, ErrorPlace place, const std::string& message, std::string detail = {});

    [[nodiscard]] ErrorKind kind() const { return kind_; }
    [[nodiscard]] const ErrorPlace& place() const { return place_; }
    [[nodiscard]] const std::string& message() const { return message_; }
    [[nodiscard]] const std::string& detail() const { return detail_; }

private:
    ErrorKind kind_;
    ErrorPlace place_;
    std::string message_;
    std::string detail_;
};

/// The error of a scene value: "KEY: VALUE is not allowed here: ALLOWED" at `key`. The scene reader
/// adds file, line and column.
Error scene_error(const std::string& key, const std::string& value, const std::string& allowed);

/// The error of a file that cannot be read or written: "FILE: REASON".
Error file_error(const std::string& file, const std::string& reason, std::string detail = {});

}  // namespace weft
