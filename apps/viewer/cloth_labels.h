// Text over the cloths: a plate of lines for each, and the legend of the springs' colours.
#pragma once

#include <string>
#include <vector>

#include "viewer/canvas.h"
#include "viewer/view_area.h"

namespace weft::viewer {

/// A plate in the upper left corner of the area: lines, and a note in red below them. In a low area
/// lines share rows, so that more of the cloth is seen.
void draw_label(const Canvas& canvas, const ViewArea& area, const std::vector<std::string>& lines,
                const std::string& note);

/// In the lower left corner. @param strain_range of full colour.
void draw_strain_legend(const Canvas& canvas, const ViewArea& area, float strain_range);
void draw_kind_legend(const Canvas& canvas, const ViewArea& area);

}  // namespace weft::viewer
