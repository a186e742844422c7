// Where the parts of the window stand. No window.
#pragma once

namespace weft::viewer {

struct Place {
    float left = 0.0F, top = 0.0F, width = 0.0F, height = 0.0F;
};

/// All in screen units. A panel that finds no room has no width.
struct WindowLayout {
    Place change, know;     ///< the panels at the left and at the right
    Place bar;              ///< along the bottom
    Place cloth;            ///< between them
    bool two_rows = false;  ///< of controls in the bar
};

/// @param text_height the unit of all widths.  @param panels whether they are wanted.
/// @param timeline whether the bar has one, in a row of its own.
WindowLayout lay_out(float width, float height, float text_height, bool panels, bool timeline);

}  // namespace weft::viewer
