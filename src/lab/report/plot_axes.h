// The axes of a plot: what can be drawn on them, how far they reach, and where their tics are.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "lab/section.h"

namespace weft::lab {

/// From `low` to `high`, with some room around everything drawn; low < high.
struct AxisRange {
    double low = 0.0, high = 1.0;
};

/// Whether a point is finite, and positive where an axis is logarithmic.
bool can_draw(const Plot& plot, const std::array<double, 2>& point);

/// Whether any point of any series can be drawn.
bool has_points(const Plot& plot);

/// The range that holds every point and label that can be drawn; of an empty plot, 0 to 1 (0.1
/// to 1 where it is logarithmic).
/// @param axis 0: x, 1: y.
AxisRange range_of(const Plot& plot, std::size_t axis);

/// gnuplot's commands for range, scale and tics of an axis.
/// @param name 'x' or 'y'.
std::string axis_commands(char name, const AxisRange& range, bool logarithmic);

}  // namespace weft::lab
