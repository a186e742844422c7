#include "viewer/flight_pace.h"

#include <algorithm>

namespace weft::viewer {

void FlightPace::set(double speed, double frame_length) {
    if (speed == speed_ && frame_length == frame_length_) return;
    speed_ = speed;
    frame_length_ = frame_length;
    if (done_.empty()) return;
    const Clock::time_point last = done_.back();
    done_.assign(1, last);
    due_ = last + interval();
}

// Of an hour at most: the clock's numbers end somewhere.
FlightPace::Clock::duration FlightPace::interval() const {
    constexpr double longest = 3600.0;
    return std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(std::min(frame_length_ / speed_, longest)));
}

void FlightPace::begin(Clock::time_point now) {
    due_ = now;
    done_.assign(1, now);
}

void FlightPace::frame_done(Clock::time_point now) {
    due_ = std::max(due_ + interval(), now - interval());
    done_.push_back(now);
    while (done_.size() > 2 && now - done_[1] >= std::chrono::seconds(1)) done_.pop_front();
}

void FlightPace::rest() {
    done_.clear();
}

double FlightPace::reached_speed() const {
    if (done_.size() < 2) return 0.0;
    const std::chrono::duration<double> passed = done_.back() - done_.front();
    const double simulated = static_cast<double>(done_.size() - 1) * frame_length_;
    return simulated < speed_ * passed.count() ? simulated / passed.count() : speed_;
}

}  // namespace weft::viewer
