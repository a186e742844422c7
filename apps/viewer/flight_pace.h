// When the next frame of a flight is due, and how fast it really goes.
#pragma once

#include <chrono>
#include <deque>

namespace weft::viewer {

/// Simulated time runs at `speed` times wall-clock time. A machine that cannot keep up runs without
/// a rest; it never has more than one frame to catch up with.
class FlightPace {
public:
    using Clock = std::chrono::steady_clock;

    /// @param speed simulated seconds a second.  @param frame_length [s], simulated.
    void set(double speed, double frame_length);
    void begin(Clock::time_point now);  ///< the next frame is due at once
    void frame_done(Clock::time_point now);
    void rest();

    [[nodiscard]] Clock::time_point due() const { return due_; }
    /// Over the last second or the last frame, at most the speed wanted; 0 at rest.
    [[nodiscard]] double reached_speed() const;

private:
    [[nodiscard]] Clock::duration interval() const;

    double speed_ = 1.0, frame_length_ = 1.0 / 30.0;
    Clock::time_point due_{};
    std::deque<Clock::time_point> done_;  ///< when it began, and the frames since
};

}  // namespace weft::viewer
