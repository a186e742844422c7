// A slider that holds its own name and value, with room for what is beyond a limit.
#pragma once

#include <limits>
#include <string>

#include "viewer/slider_scale.h"

namespace weft::viewer {

struct SliderLook {
    std::string label;
    std::string unit;
    std::string automatic{};  ///< said in place of the value, where that is chosen by weft
    double limit = std::numeric_limits<double>::infinity();  ///< what lies beyond is marked red
    bool beyond = false;   ///< what comes of the value is, so that the fill is red too
    float width = 0.0F;    ///< [screen units]; 0: all there is
    bool changed = false;  ///< from the scene file: marked by a dot
};

struct SliderAnswer {
    bool edited = false;    ///< the value is another
    bool released = false;  ///< the hand let go, or Enter was pressed
    bool reset = false;     ///< right click: back to the value of the scene file
    bool hovered = false;   ///< the mouse is on it
};

/// As wide as the panel lets it be. A drag sets the value, within the scale; double click or
/// Ctrl+click takes a number from the keyboard, within nothing.
SliderAnswer value_slider(const char* id, double& value, const SliderScale& scale,
                          const SliderLook& look);

/// Without an exponent where that is shorter to read: "1020", not "1.02e+03".
std::string brief(double value, int digits);
/// A number as the window shows it: four digits and its unit.
std::string with_unit(double value, const std::string& unit);

}  // namespace weft::viewer
