// gnuplot's SVG made part of a page: its colours follow the page's, its names clash with no
// other's.
#pragma once

#include <string>

namespace weft::lab {

/// What the picture says to those who cannot see it.
struct SvgText {
    std::string title, description;
};

/// @param svg as gnuplot wrote it, by a script of PlotCanvas::Kind::page.
/// @param name unique in the page, of letters, digits and "-": every id in the result is it, a dot,
///        and more.
/// @return an <svg role="img"> element of HTML. Black is currentColor; plot_colours() are
///         var(--line0) to var(--line7), grid_colour is var(--grid); text has the page's font.
std::string inline_svg(const std::string& svg, const std::string& name, const SvgText& text);

}  // namespace weft::lab
