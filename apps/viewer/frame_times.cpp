#include "viewer/frame_times.h"

#include <algorithm>

namespace weft::viewer {

double seconds_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

double median_of(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
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
    return median_of(latest_);
}

double Durations::latest() const {
    return latest_.empty() ? 0.0 : latest_[(count_ - 1) % kept];
}

}  // namespace weft::viewer
