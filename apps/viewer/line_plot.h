// Plots of numbers over time.
#pragma once

#include <imgui.h>

#include <span>
#include <string>

#include "viewer/time_series.h"

namespace weft::viewer {

struct PlotLine {
    const TimeSeries* series;
    ImU32 colour;
    std::string label;  ///< in the legend; empty: not there
};

struct PlotLook {
    std::string title;
    std::string present{};  ///< the number now, with its unit
    std::string unit{};     ///< of the axis
    float height = 3.2F;    ///< in heights of text
};

/// The lines over the latest 20 s, with the lowest and the highest value (or 0) at the left, and a
/// legend below that shows each line's present value.
void line_plot(const PlotLook& look, std::span<const PlotLine> lines);

}  // namespace weft::viewer
