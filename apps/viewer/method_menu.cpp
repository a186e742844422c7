#include "viewer/method_menu.h"

#include <fmt/format.h>
#include <imgui.h>

#include "viewer/controls.h"
#include "weft/integrators.h"

namespace weft::viewer {

namespace {

const char* word_of(IntegratorKind kind) {
    switch (kind) {
        case IntegratorKind::explicit_steps:
            return "explicit";
        case IntegratorKind::adaptive:
            return "by error";
        case IntegratorKind::implicit:
            return "implicit";
        case IntegratorKind::by_springs:
            return "by springs";
    }
    return "";
}

void method_tooltip(const IntegratorInfo& info) {
    std::string text = fmt::format(
        "{}\nForces a step: {}", info.formula,
        info.evaluations > 0 ? std::to_string(info.evaluations) : "as many as it takes");
    if (info.symplectic) text += "\nSymplectic: the error of the energy stays bounded.";
    tooltip_of_last(text);
}

}  // namespace

std::string summary_of_method(std::string_view name) {
    const IntegratorInfo* info = find_integrator(name);
    if (info == nullptr) return {};
    return fmt::format("order {}, {}", info->order, word_of(info->kind));
}

std::optional<std::string_view> method_menu(const char* id, const std::string& present,
                                            bool with_auto, float width) {
    std::optional<std::string_view> chosen;
    ImGui::SetNextItemWidth(width);
    if (!ImGui::BeginCombo(id, present.c_str(), ImGuiComboFlags_HeightLargest)) return chosen;
    const float column = 13.0F * em();
    if (with_auto) {
        if (ImGui::Selectable("auto", present == "auto", 0, {column + 10.0F * em(), 0.0F})) {
            chosen = "auto";
        }
        ImGui::SameLine(column);
        ImGui::TextDisabled("the cheapest for this scene");
    }
    for (const IntegratorInfo& info : integrator_catalogue()) {
        const std::string name(info.name);
        if (ImGui::Selectable(name.c_str(), present == name, 0, {column + 10.0F * em(), 0.0F})) {
            chosen = info.name;
        }
        method_tooltip(info);
        ImGui::SameLine(column);
        ImGui::TextDisabled("%s", summary_of_method(info.name).c_str());
    }
    ImGui::EndCombo();
    return chosen;
}

}  // namespace weft::viewer
