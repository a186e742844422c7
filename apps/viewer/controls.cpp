#include "viewer/controls.h"

#include <imgui.h>

#include <cmath>

namespace weft::viewer {

namespace {

constexpr float tooltip_delay = 0.5F;  // [s]

// Draws signs in a square of side 2 around a middle.
class Pen {
public:
    Pen(ImVec2 middle, float unit, ImU32 colour)
        : list_(ImGui::GetWindowDrawList()), middle_(middle), unit_(unit), colour_(colour) {}

    void triangle(float x, float side) const {  // points right, or left where side < 0
        list_->AddTriangleFilled(at(x, -0.8F), at(x + 1.4F * side, 0.0F), at(x, 0.8F), colour_);
    }
    void bar(float left, float right) const {
        list_->AddRectFilled(at(left, -0.8F), at(right, 0.8F), colour_);
    }
    void box(float half) const {
        list_->AddRectFilled(at(-half, -half), at(half, half), colour_, 0.2F * unit_);
    }
    void disc(float radius) const { list_->AddCircleFilled(middle_, radius * unit_, colour_); }
    void line(float x0, float y0, float x1, float y1) const {
        list_->AddLine(at(x0, y0), at(x1, y1), colour_, 0.28F * unit_);
    }
    // An open ring with a head; turned the other way where side < 0.
    void turn(float side) const {
        constexpr float from = -2.4F, to = 2.0F;
        constexpr int pieces = 20;
        for (int n = 0; n <= pieces; ++n) {
            const float angle = from + (to - from) * static_cast<float>(n) / pieces;
            list_->PathLineTo(at(side * 0.75F * std::cos(angle), 0.75F * std::sin(angle)));
        }
        list_->PathStroke(colour_, ImDrawFlags_None, 0.26F * unit_);
        const float x = side * 0.75F * std::cos(from), y = 0.75F * std::sin(from);
        list_->AddTriangleFilled(at(x - side * 0.55F, y + 0.1F), at(x + side * 0.35F, y - 0.5F),
                                 at(x + side * 0.3F, y + 0.55F), colour_);
    }
    void camera() const {
        list_->AddRect(at(-0.95F, -0.5F), at(0.95F, 0.75F), colour_, 0.2F * unit_, ImDrawFlags_None,
                       0.22F * unit_);
        list_->AddRectFilled(at(-0.35F, -0.8F), at(0.35F, -0.45F), colour_);
        list_->AddCircle(at(0.0F, 0.12F), 0.34F * unit_, colour_, 0, 0.2F * unit_);
    }
    void text(const char* sign) const {
        const ImVec2 size = ImGui::CalcTextSize(sign);
        list_->AddText(
            {std::round(middle_.x - 0.5F * size.x), std::round(middle_.y - 0.5F * size.y)}, colour_,
            sign);
    }

private:
    [[nodiscard]] ImVec2 at(float x, float y) const {
        return {middle_.x + x * unit_, middle_.y + y * unit_};
    }
    ImDrawList* list_;
    ImVec2 middle_;
    float unit_;
    ImU32 colour_;
};

void draw_icon(Icon icon, const Pen& pen) {
    switch (icon) {
        case Icon::play:
            return pen.triangle(-0.6F, 1.0F);
        case Icon::pause:
            pen.bar(-0.7F, -0.2F);
            return pen.bar(0.2F, 0.7F);
        case Icon::step:
            pen.triangle(-0.7F, 0.75F);
            return pen.bar(0.45F, 0.75F);
        case Icon::step_back:
            pen.triangle(0.7F, -0.75F);
            return pen.bar(-0.75F, -0.45F);
        case Icon::reset:
            return pen.turn(1.0F);
        case Icon::undo:
            return pen.turn(1.0F);
        case Icon::redo:
            return pen.turn(-1.0F);
        case Icon::record:
            return pen.disc(0.7F);
        case Icon::stop:
            return pen.box(0.65F);
        case Icon::camera:
            return pen.camera();
        case Icon::help:
            return pen.text("?");
        case Icon::slower:
            return pen.line(-0.6F, 0.0F, 0.6F, 0.0F);
        case Icon::faster:
            pen.line(-0.6F, 0.0F, 0.6F, 0.0F);
            return pen.line(0.0F, -0.6F, 0.0F, 0.6F);
        case Icon::cross:
            pen.line(-0.45F, -0.45F, 0.45F, 0.45F);
            return pen.line(-0.45F, 0.45F, 0.45F, -0.45F);
    }
}

}  // namespace

bool icon_button(Icon icon, const char* id, const std::string& tooltip, bool enabled,
                 ImU32 colour) {
    const float side = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(id);
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button("##icon", {icon_width(), side});
    ImGui::EndDisabled();
    ImGui::PopID();
    const ImVec2 middle{corner.x + 0.5F * icon_width(), corner.y + 0.5F * side};
    draw_icon(icon, Pen(middle, 0.3F * side, enabled ? colour : colours::lines));
    tooltip_of_last(tooltip);
    return pressed && enabled;
}

float icon_width() {
    return 1.25F * ImGui::GetFrameHeight();
}

bool text_button(const char* label, bool enabled, float width) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label, {width, 0.0F});
    ImGui::EndDisabled();
    return pressed && enabled;
}

bool main_button(const char* label) {
    ImGui::PushStyleColor(ImGuiCol_Button, colours::accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, IM_COL32(250, 198, 108, 255));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, IM_COL32(222, 160, 56, 255));
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(30, 26, 16, 255));
    const bool pressed = ImGui::Button(label);
    ImGui::PopStyleColor(4);
    return pressed;
}

float tick_width(const char* label) {
    const ImGuiStyle& style = ImGui::GetStyle();
    return style.ItemSpacing.x + ImGui::GetFrameHeight() + ImGui::CalcTextSize(label).x +
           2.0F * style.ItemInnerSpacing.x;
}

bool mouse_rests() {
    static double moved_at = 0.0;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F || ImGui::IsAnyMouseDown()) {
        moved_at = ImGui::GetTime();
    }
    return ImGui::GetTime() - moved_at > tooltip_delay;
}

void show_tooltip(const std::string& text) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(24.0F * em());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void tooltip_of_last(const std::string& text) {
    const bool rests = mouse_rests();
    if (text.empty() || !rests || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        return;
    show_tooltip(text);
}

void text_at_right(const std::string& text, ImU32 colour) {
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
}

void coloured_text(ImU32 colour, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void fact(const char* name, const std::string& value, ImU32 colour) {
    ImGui::PushStyleColor(ImGuiCol_Text, colours::faint);
    ImGui::TextUnformatted(name);
    ImGui::PopStyleColor();
    text_at_right(value, colour);
}

bool begin_panel(const char* name, const Place& place, bool scrolls) {
    ImGui::SetNextWindowPos({place.left, place.top});
    ImGui::SetNextWindowSize({place.width, place.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                             ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                             ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
    if (!scrolls) flags |= ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    const bool seen = ImGui::Begin(name, nullptr, flags);
    ImGui::PopStyleVar();
    return seen;
}

void end_panel() {
    ImGui::End();
}

bool section(const char* name, bool open_at_first) {
    return ImGui::CollapsingHeader(name, open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

}  // namespace weft::viewer
