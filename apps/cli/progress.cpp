#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace weft {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::string duration_text(double seconds) {
    if (seconds < 60.0) return fmt::format("{:.0f} s", seconds);
    const int minutes = static_cast<int>(seconds / 60.0);
    if (minutes < 60) return fmt::format("{} min {:02.0f} s", minutes, seconds - 60.0 * minutes);
    return fmt::format("{:.1f} h", seconds / 3600.0);
}

Progress::Progress(std::size_t frame_count, bool enabled)
    : frame_count_(frame_count),
      enabled_(enabled && frame_count > 0),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      shown_(start_) {}

Progress::~Progress() {
    end();
}

bool Progress::due(std::size_t frame) {
    if (!enabled_) return false;
    if (terminal_) {
        if (frame < frame_count_ && seconds_since(shown_) < 0.1) return false;
        shown_ = std::chrono::steady_clock::now();
        return true;
    }
    if (frame < next_frame_ && frame < frame_count_) return false;
    next_frame_ = frame + std::max<std::size_t>(frame_count_ / 10, 1);
    return true;
}

std::string Progress::pace(std::size_t frame, double time) const {
    const double per_frame =
        seconds_since(start_) / static_cast<double>(std::max<std::size_t>(frame, 1));
    return fmt::format("frame {}/{}  t {:.2f} s  {:.1f} ms/frame  {} left", frame, frame_count_,
                       time, 1e3 * per_frame,
                       duration_text(per_frame * static_cast<double>(frame_count_ - frame)));
}

void Progress::show(const std::string& line) {
    if (terminal_) {
        fmt::print(stderr, "\r{}\x1b[K", line);
        std::fflush(stderr);
        line_open_ = true;
    } else {
        fmt::print(stderr, "{}\n", line);
    }
}

void Progress::update(const Simulation& simulation) {
    if (!due(simulation.frame())) return;
    show(fmt::format("{}  strain {:.1f} %  energy {:.4g} J",
                     pace(simulation.frame(), simulation.time()),
                     100.0 * simulation.largest_strain().strain, simulation.energy().total()));
}

void Progress::update(std::size_t frame, double time) {
    if (due(frame)) show(pace(frame, time));
}

void Progress::end() {
    if (line_open_) fmt::print(stderr, "\n");
    line_open_ = false;
}

}  // namespace weft
