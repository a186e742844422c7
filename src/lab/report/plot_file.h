// Plots drawn by gnuplot.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lab/section.h"

namespace weft::lab {

/// A plot to draw.
struct PlotJob {
    const Plot* plot;
    std::string name;     ///< of the figure in the page: its ids begin with it
    bool narrow = false;  ///< for two columns
};

/// A plot as drawn.
struct DrawnPlot {
    std::string inline_svg;  ///< an element of the page
    std::string svg, png;    ///< whole files, on white
};

/// Draws all, several at once. A plot without a point is an empty frame that says "no data".
/// @return the drawings in the order of the jobs.
/// @throws Error (file) with gnuplot's message where it fails.
std::vector<DrawnPlot> draw_plots(std::span<const PlotJob> jobs);

}  // namespace weft::lab
