// How lines of plots look: colour, mark and dashes, the same for a method in every plot.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lab/section.h"

namespace weft::lab {

/// A colour of lines and marks, on white and on the dark page.
struct PlotColour {
    std::string_view light, dark;  ///< "#rrggbb"
};

/// Seven colours for methods, then the neutral grey. Both columns have a contrast of at least 3 to
/// their background, and differ for readers of every kind of colour blindness.
std::span<const PlotColour> plot_colours();
constexpr std::size_t neutral_colour = 7;

/// Backgrounds that the colours are seen on.
constexpr PlotColour page_background{"#ffffff", "#14171c"};
/// Lines of the grid behind a plot.
constexpr PlotColour grid_colour{"#dcdfe3", "#2c323a"};

struct PlotLook {
    std::size_t colour;  ///< of plot_colours()
    int mark;            ///< gnuplot's point type
    std::size_t dash;    ///< of dash_patterns()
    bool operator==(const PlotLook&) const = default;
};

/// Dashes as gnuplot's "dt": solid first.
std::span<const std::string_view> dash_patterns();

/// The look number n, for what is no method. Those below 35 differ in colour and mark, and in
/// colour and dashes.
PlotLook numbered_look(std::size_t n);

/// A method's look, the same in every plot; all differ as above.
/// @return nothing where no such method exists.
std::optional<PlotLook> method_look(std::string_view method);

/// The looks of a plot's series, in their order. Methods have their own; "neutral" is grey; any
/// other look, and none, takes one that no method of the plot has. Two named lines of one look
/// differ in their dashes.
std::vector<PlotLook> looks_of(const Plot& plot);

}  // namespace weft::lab
