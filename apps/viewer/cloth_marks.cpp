// Marks are dark around and bright within, so that they are seen on cloth and on sky.
#include "viewer/cloth_marks.h"

#include <cmath>
#include <string>
#include <variant>

#include "viewer/label_text.h"

namespace weft::viewer {

namespace {

constexpr ImU32 dark = IM_COL32(20, 24, 32, 200);
constexpr ImU32 bright = IM_COL32(255, 255, 255, 255);
constexpr ImU32 amber = IM_COL32(255, 196, 84, 255);

void draw_ring(const Canvas& canvas, ImVec2 centre, float radius, ImU32 colour) {
    canvas.list->AddCircle(centre, radius, dark, 0, canvas.length(4.0F));
    canvas.list->AddCircle(centre, radius, colour, 0, canvas.length(2.0F));
}

void draw_bar(const Canvas& canvas, ImVec2 from, ImVec2 to, ImU32 colour) {
    canvas.list->AddLine(from, to, dark, canvas.length(5.0F));
    canvas.list->AddLine(from, to, colour, canvas.length(2.5F));
}

void draw_sphere_outline(const Canvas& canvas, const ViewArea& area, const Camera& camera,
                         const SphereObstacle& sphere) {
    const glm::vec3 centre = to_glm(sphere.centre);
    const auto pixel = pixel_of(area, camera, centre);
    const float distance = glm::distance(centre, camera.eye);
    const auto radius = static_cast<float>(sphere.radius);
    if (!pixel || distance <= radius) return;
    // Seen from outside, half the angle of a sphere is asin(radius / distance).
    const float tangent = radius / std::sqrt(distance * distance - radius * radius);
    const float half_height = 0.5F * static_cast<float>(area.height);
    const float pixels =
        half_height * tangent / std::tan(0.5F * glm::radians(camera.field_of_view));
    draw_ring(canvas, canvas.at(*pixel), pixels / canvas.pixels_per_unit, amber);
}

void draw_obstacle(const Canvas& canvas, const ViewArea& area, const Camera& camera,
                   const Shown& shown, const TouchTarget& target) {
    const auto& shape = shown.obstacles[target.obstacle].shape;
    if (const auto* sphere = std::get_if<SphereObstacle>(&shape))
        return draw_sphere_outline(canvas, area, camera, *sphere);
    const Stage& stage = shown.cloths[target.cloth].shape->stage;
    for (const PlaneHandle& handle : plane_handles(shown.obstacles, stage)) {
        if (handle.obstacle != target.obstacle) continue;
        const glm::vec3 arrow = handle.length * handle.normal;
        const auto low = pixel_of(area, camera, handle.middle - arrow);
        const auto high = pixel_of(area, camera, handle.middle + arrow);
        if (low && high) draw_bar(canvas, canvas.at(*low), canvas.at(*high), amber);
    }
}

}  // namespace

void draw_target(const Canvas& canvas, const ViewArea& area, const Camera& camera,
                 const Shown& shown, const TouchTarget& target) {
    if (target.kind == PointerTarget::nothing) return;
    if (target.kind == PointerTarget::obstacle)
        return draw_obstacle(canvas, area, camera, shown, target);
    const auto& positions = shown.cloths[target.cloth].frame.positions;
    const auto pixel = pixel_of(area, camera, to_glm(positions[target.particle]));
    if (!pixel) return;
    const bool pin = target.kind == PointerTarget::pin;
    draw_ring(canvas, canvas.at(*pixel), canvas.length(pin ? 9.0F : 5.0F), pin ? amber : bright);
}

void draw_hold(const Canvas& canvas, const ViewArea& area, const Camera& camera, glm::vec3 particle,
               glm::vec3 hand, double newtons) {
    const auto from = pixel_of(area, camera, particle), to = pixel_of(area, camera, hand);
    if (!from || !to) return;
    draw_bar(canvas, canvas.at(*from), canvas.at(*to), amber);
    draw_ring(canvas, canvas.at(*from), canvas.length(5.0F), amber);
    const std::string text = force_text(newtons);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float inset = canvas.length(4.0F);
    const ImVec2 cursor = canvas.at(*to);
    const ImVec2 low{cursor.x + canvas.length(14.0F), cursor.y + canvas.length(8.0F)};
    canvas.list->AddRectFilled({low.x - inset, low.y - inset},
                               {low.x + size.x + inset, low.y + size.y + inset}, dark,
                               canvas.length(4.0F));
    canvas.list->AddText(low, amber, text.c_str());
}

ImGuiMouseCursor cursor_of(const TouchTarget& target) {
    switch (target.kind) {
        case PointerTarget::cloth:
            return ImGuiMouseCursor_Hand;
        case PointerTarget::pin:
        case PointerTarget::obstacle:
            return ImGuiMouseCursor_ResizeAll;
        case PointerTarget::nothing:
            break;
    }
    return ImGuiMouseCursor_Arrow;
}

}  // namespace weft::viewer
