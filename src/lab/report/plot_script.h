// A plot as gnuplot's commands.
#pragma once

#include <string>

#include "lab/section.h"

namespace weft::lab {

/// What a script draws on.
struct PlotCanvas {
    enum class Kind {
        page,  ///< SVG for the inside of a page: no background, no title
        svg,   ///< SVG that stands alone, on white
        png,   ///< the same as PNG
    };
    Kind kind = Kind::svg;
    bool narrow = false;  ///< for two columns: 720 wide in place of 960, the key below
};

/// The commands that draw the plot to standard output. Text is drawn as it is, whatever it holds.
/// Lines break where points cannot be drawn; lines of more than 1200 points are thinned to the
/// lowest and the highest of each stretch, which looks the same.
std::string plot_script(const Plot& plot, const PlotCanvas& canvas);

}  // namespace weft::lab
