// The bar at the bottom: play, step, speed, time; recordings being made, or the timeline of one.
#pragma once

#include "viewer/controls.h"
#include "viewer/workbench.h"

namespace weft::viewer {

/// @param open called with a file to open instead.
void transport_bar(const WindowLayout& layout, Workbench& bench, WindowSettings& settings,
                   const Act& act, const std::function<void(const std::string&)>& open);

/// The next speed up or down of those that the bar offers.
double next_speed(double present, bool faster);

}  // namespace weft::viewer
