// Running gnuplot as a child process, without a shell.
#pragma once

#include <string>

namespace weft {

/// What a run of gnuplot came to.
struct GnuplotRun {
    int status = -1;       ///< as of waitpid(); -1: gnuplot could not be started
    std::string output;    ///< its standard output
    std::string messages;  ///< its standard error
    [[nodiscard]] bool ok() const { return status == 0; }
};

/// Gives `script` to gnuplot and waits for its end. The user's own settings are not read.
GnuplotRun run_gnuplot(const std::string& script);

}  // namespace weft
