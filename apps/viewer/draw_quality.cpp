// A level is left at once and regained slowly.
#include "viewer/draw_quality.h"

#include <algorithm>
#include <cassert>

#include "viewer/frame_times.h"

namespace weft::viewer {

namespace {

constexpr std::size_t window = 5;      // samples that decide
constexpr double room = 0.8;           // of the limit, that a better level must keep to
constexpr double unknown_ratio = 1.5;  // of costs, where no transition has shown it
constexpr double least_patience = 2.0, most_patience = 64.0;  // [s]
constexpr double trial = 10.0;                                // that a regained level must hold [s]

}  // namespace

DrawQuality::DrawQuality(std::size_t levels, std::size_t first, double limit)
    : limit_(limit),
      level_(first),
      ratios_(levels, unknown_ratio),
      risen_(-trial),
      patience_(least_patience) {
    assert(first < levels);
}

double DrawQuality::typical() const {
    return median_of(samples_);
}

bool DrawQuality::pressed() const {
    return samples_.empty() || samples_.back() > 0.75 * limit_;
}

void DrawQuality::learn_ratio(double typical) {
    if (left_at_ <= 0.0) return;
    ratios_[level_ - 1] = std::clamp(left_at_ / std::max(typical, 1e-3), 1.05, 6.0);
    left_at_ = 0.0;
}

void DrawQuality::go_to(std::size_t level, double time) {
    level_ = level;
    changed_ = time;
    samples_.clear();
}

void DrawQuality::add(double time, double milliseconds) {
    if (samples_.size() == window) samples_.erase(samples_.begin());
    samples_.push_back(milliseconds);
    if (samples_.size() < window) return;
    const double cost = typical();
    learn_ratio(cost);
    if (cost > limit_ && level_ + 1 < ratios_.size()) {
        const bool failed_trial = time - risen_ < trial;
        patience_ = failed_trial ? std::min(2.0 * patience_, most_patience) : least_patience;
        go_to(level_ + 1, time);
        left_at_ = cost;
    } else if (level_ > 0 && time - changed_ >= patience_ &&
               cost * ratios_[level_ - 1] < room * limit_) {
        go_to(level_ - 1, time);
        risen_ = time;
    }
}

}  // namespace weft::viewer
