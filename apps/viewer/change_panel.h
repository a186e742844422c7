// The panel at the left: everything about a scene that can be changed while it flies.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "viewer/controls.h"
#include "viewer/value_slider.h"
#include "viewer/workbench.h"

namespace weft::viewer {

class ChangePanel {
public:
    void draw(const Place& place, Workbench& bench, WindowSettings& settings, const Act& act);

private:
    void draw_scene(Workbench& bench, WindowSettings& settings, const Act& act);
    void draw_method(Workbench& bench);
    void draw_parameters(Workbench& bench);
    void draw_parameter(const Parameter& parameter, Workbench& bench);
    static void draw_tick(const Parameter& parameter, Workbench& bench);
    void take_answer(const Parameter& parameter, Workbench& bench, const SliderAnswer& answer,
                     double value);

    /// Of a parameter that restarts the motion: where its slider is, until the hand lets go.
    std::map<std::string_view, double> held_;
};

/// What is shown of a cloth, for scenes and recordings.
void see_section(WindowSettings& settings, bool recording);
/// The text of a refusal under what was to be changed, where there is one.
void show_refusal(const Workbench& bench, const std::string& what);
/// On the slider of a lane's step: the stable one, where steps that long are taken, and whether the
/// one that is taken lies beyond.
void mark_stable_step(SliderLook& look, const LaneView& lane, const SceneDescription& scene);

}  // namespace weft::viewer
