#include "viewer/dialog_frame.h"

#include <imgui.h>

#include <algorithm>

#include "viewer/theme.h"

namespace weft::viewer {

bool begin_dialog(const char* title, bool is_open, float width) {
    if (is_open && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(width * em(), 0.96F * screen.x), 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {1.1F * em(), 0.9F * em()});
    const bool open =
        ImGui::BeginPopupModal(title, nullptr,
                               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    if (!open) return false;
    if (!is_open) {
        ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
        return false;
    }
    ImGui::TextUnformatted(title);
    ImGui::Separator();
    ImGui::Spacing();
    return true;
}

void end_dialog() {
    ImGui::EndPopup();
}

void take_keyboard() {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-FLT_MIN);
}

}  // namespace weft::viewer
