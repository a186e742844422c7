#include "viewer/value_slider.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "viewer/theme.h"

namespace weft::viewer {

namespace {

constexpr float drag_threshold = 3.0F;  // a click alone moves nothing

// Press of the slider that is held; ImGui has one active item at a time.
struct Press {
    float at = 0.0F;
    bool dragged = false;
};
Press press;

// The slider that takes a number from the keyboard; it counts when that is done, not digit by
// digit.
struct Typing {
    ImGuiID id = 0;
    double value = 0.0;
};
Typing typing;
constexpr const char* typed_format = "%.6g";

void draw_slider(const ImRect& box, ImGuiID id, bool hovered, double value,
                 const SliderScale& scale, const SliderLook& look) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImGuiStyle& style = ImGui::GetStyle();
    const bool active = ImGui::GetActiveID() == id;
    const float rounding = style.FrameRounding;
    list->AddRectFilled(box.Min, box.Max,
                        hovered || active ? colours::groove_hovered : colours::groove, rounding);
    const auto x_of = [&](double v) {
        return box.Min.x + static_cast<float>(scale.place_of(v)) * box.GetWidth();
    };
    const bool has_limit = look.limit < scale.high;
    if (has_limit) {
        list->AddRectFilled({x_of(look.limit), box.Min.y}, box.Max,
                            (colours::forbidden & 0x00FFFFFFU) | 0x90000000U, rounding,
                            ImDrawFlags_RoundCornersRight);
    }
    const float end = x_of(value);
    if (end > box.Min.x + rounding) {
        const ImU32 fill = look.beyond ? colours::forbidden
                           : active    ? colours::fill_active
                                       : colours::fill;
        list->AddRectFilled(box.Min, {end, box.Max.y}, fill, rounding);
    }
    if (has_limit) {
        const float x = x_of(look.limit);
        list->AddLine({x, box.Min.y}, {x, box.Max.y}, colours::trouble, 2.0F);
    }
    const std::string shown = look.automatic.empty() ? with_unit(value, look.unit) : look.automatic;
    const float value_width = ImGui::CalcTextSize(shown.c_str()).x;
    const ImVec2 pad = style.FramePadding;
    const float value_left = box.Max.x - pad.x - value_width;
    list->AddText({value_left, box.Min.y + pad.y},
                  look.automatic.empty() ? colours::text : colours::faint, shown.c_str());
    ImGui::RenderTextEllipsis(list, {box.Min.x + pad.x, box.Min.y + pad.y},
                              {value_left - pad.x, box.Max.y}, value_left - pad.x,
                              value_left - pad.x, look.label.c_str(), nullptr, nullptr);
    if (look.changed) {
        list->AddCircleFilled({box.Min.x + 0.5F * pad.x, 0.5F * (box.Min.y + box.Max.y)},
                              0.2F * pad.x + 0.5F, colours::accent);
    }
}

// @return whether the value is another.
bool follow_drag(const ImRect& box, double& value, const SliderScale& scale) {
    const float x = ImGui::GetIO().MousePos.x;
    if (!press.dragged && std::abs(x - press.at) < drag_threshold) return false;
    press.dragged = true;
    const double wanted = scale.value_at((x - box.Min.x) / box.GetWidth());
    if (wanted == value) return false;
    value = wanted;
    return true;
}

// @return whether the value is another. What was shown, and is as it was, is not: it was rounded.
bool take_typed(double& value) {
    std::array<char, 40> before{}, after{};
    std::snprintf(before.data(), before.size(), typed_format, value);
    std::snprintf(after.data(), after.size(), typed_format, typing.value);
    if (!std::isfinite(typing.value) || before == after) return false;
    value = typing.value;
    return true;
}

// @return whether the keyboard is wanted.
bool take_press(ImGuiWindow* window, ImGuiID id, bool hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!hovered || !io.MouseClicked[0]) return false;
    ImGui::SetActiveID(id, window);
    ImGui::SetFocusID(id, window);
    ImGui::FocusWindow(window);
    press = {io.MousePos.x, false};
    return io.KeyCtrl || io.MouseDoubleClicked[0];
}

}  // namespace

SliderAnswer value_slider(const char* name, double& value, const SliderScale& scale,
                          const SliderLook& look) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    if (window->SkipItems) return {};
    const ImGuiID id = window->GetID(name);
    const ImVec2 corner = window->DC.CursorPos;
    const float width = look.width > 0.0F ? look.width : ImGui::GetContentRegionAvail().x;
    const ImRect box(corner, {corner.x + width, corner.y + ImGui::GetFrameHeight()});
    ImGui::ItemSize(box, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(box, id)) return {};
    const bool hovered = ImGui::ItemHoverable(box, id);
    SliderAnswer answer;
    if (ImGui::TempInputIsActive(id) || take_press(window, id, hovered)) {
        if (typing.id != id) typing = {id, value};
        ImGui::TempInputScalar(box, id, name, ImGuiDataType_Double, &typing.value, typed_format);
        return answer;
    }
    if (typing.id == id) {
        answer.edited = answer.released = take_typed(value);
        typing = {};
    }
    if (ImGui::GetActiveID() == id) {
        if (ImGui::GetIO().MouseDown[0]) {
            answer.edited = follow_drag(box, value, scale);
        } else {
            answer.released = press.dragged;
            ImGui::ClearActiveID();
        }
    }
    answer.hovered = hovered;
    answer.reset = hovered && ImGui::GetIO().MouseClicked[1];
    draw_slider(box, id, hovered, value, scale, look);
    return answer;
}

std::string brief(double value, int digits) {
    const double large = std::abs(value);
    if (large < 1e6 && large >= std::pow(10.0, digits)) {
        return fmt::format("{:.0f}", rounded_to_digits(value, digits));
    }
    return fmt::format("{:.{}g}", value, digits);
}

std::string with_unit(double value, const std::string& unit) {
    if (!std::isfinite(value)) return "any";
    return unit.empty() ? brief(value, 4) : brief(value, 4) + " " + unit;
}

}  // namespace weft::viewer
