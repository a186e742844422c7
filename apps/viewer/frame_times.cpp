#include "viewer/frame_times.h"

#include <algorithm>

namespace weft::viewer {

double seconds_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

void Durations::add(double seconds) {
    if (latest_.size() < kept) {
        latest_.push_back(seconds);
    } else {
        latest_[count_ % kept] = seconds;
    }
    ++count_;
    largest_ = std::max(largest_, seconds);
}

double Durations::median() const {
    if (latest_.empty()) return 0.0;
    std::vector<double> sorted = latest_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

double Durations::latest() const {
    return latest_.empty() ? 0.0 : latest_[(count_ - 1) % kept];
}

}  // namespace weft::viewer
