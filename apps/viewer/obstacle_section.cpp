#include "viewer/obstacle_section.h"

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/change_panel.h"
#include "viewer/scene_edits.h"
#include "viewer/value_slider.h"

namespace weft::viewer {

namespace {

constexpr double largest_friction = 2.0, largest_radius = 10.0, smallest_radius = 0.01;

struct Number {
    const char* label;
    const char* unit;
    SliderScale scale;
};

// @return whether the value is another.
bool number_row(Workbench& bench, const Number& number, double& value) {
    const SliderAnswer answer = value_slider(number.label, value, number.scale,
                                             {.label = number.label, .unit = number.unit});
    if (answer.released) bench.end_gesture();
    return answer.edited;
}

// @return whether the obstacle is to go.
bool obstacle_rows(Workbench& bench, std::size_t index, const std::string& name) {
    ObstacleDescription obstacle = bench.scene().obstacles[index];
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - icon_width());
    const bool removed = icon_button(Icon::cross, "remove", "Take it away");
    bool changed = false;
    if (auto* sphere = std::get_if<SphereObstacle>(&obstacle.shape)) {
        changed = number_row(bench, {"Radius", "m", {smallest_radius, largest_radius, true}},
                             sphere->radius);
    }
    changed =
        number_row(bench, {"Friction", "", {0.0, largest_friction, false}}, obstacle.friction) ||
        changed;
    changed = number_row(bench, {"Gap", "m", {0.0, 0.1, true}}, obstacle.gap) || changed;
    if (changed && !removed) {
        SceneDescription scene = bench.scene();
        scene.obstacles[index] = obstacle;
        bench.edit(scene, name);
    }
    show_refusal(bench, name);
    return removed;
}

}  // namespace

void obstacle_section(Workbench& bench, const Act& act) {
    if (!section("Obstacles", true)) return;
    std::optional<std::size_t> removed;
    int spheres = 0, planes = 0;
    ImGui::PushID("obstacles");
    for (std::size_t k = 0; k < bench.scene().obstacles.size(); ++k) {
        const bool is_sphere =
            std::holds_alternative<SphereObstacle>(bench.scene().obstacles[k].shape);
        ImGui::PushID(static_cast<int>(k));
        const std::string name =
            is_sphere ? fmt::format("Sphere {}", ++spheres) : fmt::format("Plane {}", ++planes);
        if (obstacle_rows(bench, k, name)) removed = k;
        ImGui::PopID();
    }
    ImGui::PopID();
    if (removed) {
        bench.edit(without_obstacle(bench.scene(), *removed), "obstacle");
        bench.end_gesture();
    }
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (text_button("Add a sphere", true, half)) act({Action::add_sphere});
    ImGui::SameLine();
    if (text_button("Add a plane", true, half)) act({Action::add_plane});
    show_refusal(bench, "obstacle");
}

}  // namespace weft::viewer
