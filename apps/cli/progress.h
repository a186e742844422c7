// What a long run says while it goes on.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

#include "weft/simulation.h"

namespace weft {

/// "40 s", "3 min 20 s", "1.5 h"
std::string duration_text(double seconds);

/// One line, updated in place at a terminal; elsewhere a plain line about every tenth of the run.
/// Writes to standard error.
class Progress {
public:
    /// @param enabled false: says nothing.
    Progress(std::size_t frame_count, bool enabled);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// After each frame of a simulation: frame, time, ms a frame, time left, largest strain,
    /// energy.
    void update(const Simulation& simulation);
    /// After each frame drawn from a recording.
    void update(std::size_t frame, double time);
    /// Ends the line at a terminal.
    void end();

private:
    [[nodiscard]] bool due(std::size_t frame);
    [[nodiscard]] std::string pace(std::size_t frame, double time) const;
    void show(const std::string& line);

    std::size_t frame_count_;
    bool enabled_, terminal_, line_open_ = false;
    std::chrono::steady_clock::time_point start_, shown_;
    std::size_t next_frame_ = 0;  ///< the next frame to be told of, away from a terminal
};

}  // namespace weft
