#include "viewer/window_layout.h"

#include <algorithm>

namespace weft::viewer {

namespace {

// In heights of text.
constexpr float narrowest_panel = 17.5F, widest_panel = 22.0F;
constexpr float narrowest_cloth = 14.0F;
constexpr float one_row_bar = 56.0F;  // what its controls need beside each other
constexpr float row_height = 2.1F, bar_margin = 0.6F;

}  // namespace

WindowLayout lay_out(float width, float height, float text_height, bool panels, bool timeline) {
    WindowLayout layout;
    layout.two_rows = timeline || width < one_row_bar * text_height;
    const float rows = layout.two_rows ? 2.0F : 1.0F;
    const float bar = std::min(height, (rows * row_height + bar_margin) * text_height);
    const float panel =
        std::clamp(0.235F * width, narrowest_panel * text_height, widest_panel * text_height);
    const float upper = height - bar;
    const bool change = panels && width >= panel + narrowest_cloth * text_height;
    const bool know = panels && width >= 2.0F * panel + narrowest_cloth * text_height;
    layout.bar = {0.0F, upper, width, bar};
    if (change) layout.change = {0.0F, 0.0F, panel, upper};
    if (know) layout.know = {width - panel, 0.0F, panel, upper};
    layout.cloth = {layout.change.width, 0.0F, width - layout.change.width - layout.know.width,
                    upper};
    return layout;
}

}  // namespace weft::viewer
