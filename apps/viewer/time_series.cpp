#include "viewer/time_series.h"

#include <algorithm>

namespace weft::viewer {

TimeSeries::TimeSeries(std::size_t capacity) : capacity_(std::max<std::size_t>(capacity, 1)) {}

void TimeSeries::add(double time, double value) {
    if (!times_.empty() && static_cast<float>(time) < times_.back()) clear();
    if (times_.size() == capacity_) {
        times_.erase(times_.begin());
        values_.erase(values_.begin());
    }
    times_.push_back(static_cast<float>(time));
    values_.push_back(static_cast<float>(value));
}

void TimeSeries::clear() {
    times_.clear();
    values_.clear();
}

}  // namespace weft::viewer
