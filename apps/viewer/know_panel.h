// The panel at the right: what is measured on the cloths while they fly.
#pragma once

#include "viewer/controls.h"
#include "viewer/workbench.h"

namespace weft::viewer {

/// What the window measures on itself.
struct WindowMeasures {
    double frames_per_second = 0.0;  ///< drawn, of late; 0: it rests
    double latency_ms = 0.0;         ///< median, from an input to its frame
    std::string quality;             ///< of the drawing
};

/// @param measure asked only where the answer is to be seen.
void know_panel(const Place& place, const Workbench& bench,
                const std::function<WindowMeasures()>& measure);
/// The same place while a recording plays.
void recording_facts(const Place& place, Workbench& bench,
                     const std::function<WindowMeasures()>& measure);

}  // namespace weft::viewer
