// The last minutes of a number, for a plot.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace weft::viewer {

/// Keeps the latest `capacity` samples in order of time; a sample at an earlier time than the last
/// (after a reset) begins anew.
class TimeSeries {
public:
    explicit TimeSeries(std::size_t capacity = 600);
    void add(double time, double value);
    void clear();
    [[nodiscard]] std::span<const float> times() const { return times_; }
    [[nodiscard]] std::span<const float> values() const { return values_; }

private:
    std::size_t capacity_;
    std::vector<float> times_, values_;
};

}  // namespace weft::viewer
