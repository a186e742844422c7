// When frames are.
#pragma once

#include <cmath>
#include <cstddef>

namespace weft {

/// Frame n is at start + n / rate, computed from its number so that no rounding adds up. A run that
/// starts at the time of another's frame m has its frames at the very times of that one's.
class FrameClock {
public:
    /// @param start of frame 0 [s].  @param rate in frames per second.
    FrameClock(double start, double rate) : rate_(rate) {
        constexpr double largest_counted = 9007199254740992.0;  // 2^53
        const double frames = std::round(start * rate);
        if (frames < largest_counted && frames / rate == start) {
            first_ = frames;
        } else {
            start_ = start;
        }
    }

    [[nodiscard]] double time(std::size_t frame) const {
        return start_ + (first_ + static_cast<double>(frame)) / rate_;
    }
    [[nodiscard]] double frame_length() const { return 1.0 / rate_; }

private:
    double rate_, start_ = 0.0;
    double first_ = 0.0;  // number of frame 0, counted from time 0, where that is a whole one
};

}  // namespace weft
