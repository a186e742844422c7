// What of a scene the window's sliders change, as one table: panel, undo and tests go by it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "weft/scene.h"

namespace weft::viewer {

/// A number of the scene on a slider. Vectors are three rows.
struct Parameter {
    std::string_view key;      ///< of the scene file, dotted; ".x", ".y", ".z" for a component
    std::string_view section;  ///< heading in the panel: "Springs", "Wind", ...
    std::string_view label;    ///< "Structural stiffness"
    std::string_view unit;     ///< "N/m"; see unit_of()
    double low, high;          ///< of the slider; numbers typed in may go beyond
    bool logarithmic;          ///< with 0 at its left end where `low` is 0
    double (*get)(const SceneDescription& scene);  ///< 0 where it is "auto"
    void (*set)(SceneDescription& scene, double value);
    bool (*applies)(const SceneDescription& scene) = nullptr;  ///< null: always
    /// Whether the cloth is made anew, and its motion begins again: its size or resolution.
    bool restarts = false;
    bool whole = false;                                    ///< rounded to whole numbers
    bool (*automatic)(const SceneDescription&) = nullptr;  ///< is it "auto"; null: it cannot be
    void (*make_automatic)(SceneDescription&) = nullptr;   ///< null likewise
};
std::span<const Parameter> parameters();
const Parameter* find_parameter(std::string_view key);

/// The unit with what it is counted per where the scene says so: "N/m of width".
std::string unit_of(const Parameter& parameter, const SceneDescription& scene);

/// The scene with one parameter changed, or what check_scene() says against it.
struct ParameterChange {
    SceneDescription scene;
    std::string refusal;  ///< empty: `scene` is allowed
};
/// @pre the parameter applies.
ParameterChange with_parameter(const SceneDescription& scene, const Parameter& parameter,
                               double value);

}  // namespace weft::viewer
