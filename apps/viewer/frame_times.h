// How fast the window draws and answers.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

namespace weft::viewer {

using Clock = std::chrono::steady_clock;
double seconds_between(Clock::time_point from, Clock::time_point to);

/// The median, of an even number the upper one; 0 of none.
double median_of(std::vector<double> values);

/// Durations, of which the median and the largest count. Of very many, the latest are kept.
class Durations {
public:
    void add(double seconds);
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] double median() const;  ///< of the latest 4096 [s]; 0: there are none
    [[nodiscard]] double latest() const;  ///< [s]; 0: there is none
    [[nodiscard]] double largest() const { return largest_; }  ///< of all [s]

private:
    static constexpr std::size_t kept = 4096;
    std::vector<double> latest_;
    std::size_t count_ = 0;
    double largest_ = 0.0;
};

}  // namespace weft::viewer
