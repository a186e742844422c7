#include "viewer/compare_section.h"

#include <imgui.h>

#include <optional>

#include "viewer/change_panel.h"
#include "viewer/controls.h"
#include "viewer/method_menu.h"
#include "weft/integrators.h"

namespace weft::viewer {

namespace {

constexpr double shortest_step = 1e-6, longest_step = 0.1;  // on the slider [s]

// A method that is not flown yet: first one of each family.
std::string_view next_method(const Workbench& bench) {
    const auto is_flown = [&bench](std::string_view name) {
        if (bench.view().lanes.front().method == name) return true;
        for (const IntegratorDescription& lane : bench.lanes()) {
            if (lane.method == name) return true;
        }
        return false;
    };
    for (const std::string_view name : {"implicit-euler", "rk4", "verlet", "xpbd", "bdf2"}) {
        if (!is_flown(name)) return name;
    }
    return "velocity-verlet";
}

void add_lane(Workbench& bench) {
    std::vector<IntegratorDescription> lanes = bench.lanes();
    lanes.push_back(lane_of(bench.scene(), next_method(bench)));
    bench.set_lanes(std::move(lanes));
}

// @return whether another method was chosen.
bool method_row(IntegratorDescription& lane, std::size_t number, bool& removed) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled(
        {at.x + 0.4F * em(), at.y + 0.5F * ImGui::GetFrameHeight()}, 0.32F * em(),
        lane_colour(number));
    ImGui::Dummy({0.8F * em(), 0.0F});
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::SameLine(0.0F, style.ItemInnerSpacing.x);
    const float width = ImGui::GetContentRegionAvail().x - icon_width() - style.ItemSpacing.x;
    const auto chosen = method_menu("##method", lane.method, true, width);
    if (chosen) lane.method = *chosen;
    ImGui::SameLine();
    removed = icon_button(Icon::cross, "remove", "Fly without this one");
    return chosen.has_value();
}

// @param view null: it does not fly yet.  @return whether the step is another.
bool step_row(IntegratorDescription& lane, const LaneView* view, std::size_t number,
              const SceneDescription& scene) {
    static std::optional<double> held;  // a lane's step takes effect when the hand lets go
    static std::size_t held_lane = 0;
    double step = lane.time_step.value_or(view != nullptr ? view->time_step : 0.001);
    SliderLook look{.label = "Step", .unit = "s"};
    if (!lane.time_step) look.automatic = with_unit(step, "s");
    if (view != nullptr) mark_stable_step(look, *view, scene);
    look.width = ImGui::GetContentRegionAvail().x - tick_width("auto");
    if (held && held_lane == number) step = *held;
    const SliderAnswer answer =
        value_slider("step", step, {shortest_step, longest_step, true}, look);
    if (answer.edited) {
        held = step;
        held_lane = number;
    }
    if (answer.released) {
        lane.time_step = step;
        held.reset();
    }
    ImGui::SameLine();
    bool automatic = !lane.time_step;
    const bool ticked = ImGui::Checkbox("auto", &automatic);
    if (ticked) lane.time_step = automatic ? std::nullopt : std::optional(step);
    return answer.released || ticked;
}

}  // namespace

void compare_section(Workbench& bench) {
    if (!section("Compare", !bench.lanes().empty())) return;
    std::vector<IntegratorDescription> lanes = bench.lanes();
    const FlightView& view = bench.view();
    bool changed = false;
    std::optional<std::size_t> removed;
    ImGui::PushID("lanes");
    for (std::size_t k = 0; k < lanes.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        bool remove = false;
        const LaneView* lane = k + 1 < view.lanes.size() ? &view.lanes[k + 1] : nullptr;
        changed = method_row(lanes[k], k + 1, remove) || changed;
        changed = step_row(lanes[k], lane, k + 1, bench.scene()) || changed;
        if (remove) removed = k;
        ImGui::PopID();
    }
    ImGui::PopID();
    if (removed) lanes.erase(lanes.begin() + static_cast<std::ptrdiff_t>(*removed));
    if (changed || removed) bench.set_lanes(lanes);
    if (bench.lanes().size() + 1 < most_lanes) {
        if (ImGui::Button("Add a method", {-FLT_MIN, 0.0F})) add_lane(bench);
        if (bench.refusal("lanes") == nullptr) {  // which it would cover
            tooltip_of_last(
                "Flies the same scene by another method beside this one. All start again.");
        }
    }
    show_refusal(bench, "lanes");
}

void toggle_comparison(Workbench& bench) {
    if (bench.lanes().empty()) {
        add_lane(bench);
    } else {
        bench.set_lanes({});
    }
}

}  // namespace weft::viewer
