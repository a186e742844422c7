#include "viewer/slider_scale.h"

#include <algorithm>
#include <cmath>

namespace weft::viewer {

namespace {

// A logarithmic scale that has 0 begins with it, and goes on at so small a part of its end.
constexpr double decades_from_zero = 8.0;
constexpr double room_of_zero = 0.03;  // of the slider

double lowest_positive(const SliderScale& scale) {
    return scale.low > 0.0 ? scale.low : scale.high * std::pow(10.0, -decades_from_zero);
}

}  // namespace

double SliderScale::place_of(double value) const {
    const double inside = std::clamp(value, low, high);
    if (!(high > low)) return 0.0;
    if (!logarithmic) return (inside - low) / (high - low);
    if (inside <= 0.0) return 0.0;
    const double lowest = lowest_positive(*this);
    const double place = std::max(0.0, std::log(inside / lowest) / std::log(high / lowest));
    return low > 0.0 ? place : room_of_zero + (1.0 - room_of_zero) * place;
}

double SliderScale::value_at(double place) const {
    double inside = std::clamp(place, 0.0, 1.0);
    if (inside == 0.0) return low;
    if (inside == 1.0) return high;
    if (logarithmic) {
        if (low <= 0.0) inside = (inside - room_of_zero) / (1.0 - room_of_zero);
        if (inside < 0.0) return low;
        const double lowest = lowest_positive(*this);
        return rounded_to_digits(lowest * std::pow(high / lowest, inside), 3);
    }
    // Of a range, so that 0 can be met: a hundredth of 10^n, n being that of the range.
    const double unit = std::pow(10.0, 2.0 - std::floor(std::log10(high - low)));
    return std::clamp(std::round((low + inside * (high - low)) * unit) / unit, low, high);
}

double rounded_to_digits(double value, int digits) {
    if (value == 0.0 || !std::isfinite(value)) return value;
    // By a power of ten that is whole, so that 0.3 does not become 0.30000000000000004.
    const int shift = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
    const double factor = std::pow(10.0, std::abs(shift));
    return shift >= 0 ? std::round(value * factor) / factor : std::round(value / factor) * factor;
}

}  // namespace weft::viewer
