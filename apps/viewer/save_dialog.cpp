#include "viewer/save_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>

#include "viewer/controls.h"
#include "viewer/dialog_frame.h"
#include "viewer/file_names.h"

namespace weft::viewer {

void SaveDialog::open(const std::string& suggested, bool may_keep_state) {
    is_open_ = true;
    may_keep_state_ = may_keep_state;
    with_state_ = may_keep_state;
    replace_ = false;
    file_ = suggested;
    complaint_.clear();
    allowed_to_replace_.clear();
}

std::optional<SaveChoice> SaveDialog::draw() {
    std::optional<SaveChoice> chosen;
    if (!begin_dialog("Save the scene", is_open_, 34.0F)) return chosen;
    take_keyboard();
    const bool entered = ImGui::InputText(
        "##file", &file_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (file_ != allowed_to_replace_) replace_ = false;
    if (may_keep_state_) {
        ImGui::Checkbox("Begin with what is on the screen", &with_state_);
        tooltip_of_last(
            "Positions, velocities and time go into a .npy file beside the scene. Without it, the "
            "scene begins as it was opened, with your changes.");
    }
    const std::string objection = objection_to_scene_file(file_);
    std::error_code unreadable;
    const bool stands = objection.empty() && std::filesystem::exists(file_, unreadable);
    if (!objection.empty()) {
        coloured_text(colours::faint, objection);
    } else if (stands) {
        coloured_text(colours::accent, is_shipped_scene_file(file_)
                                           ? "This is one of weft's own scenes."
                                           : "This file stands already.");
        if (ImGui::Checkbox("Replace it", &replace_)) allowed_to_replace_ = file_;
    }
    if (!complaint_.empty()) coloured_text(colours::trouble, complaint_);
    ImGui::Spacing();
    const bool allowed = objection.empty() && (!stands || replace_);
    ImGui::BeginDisabled(!allowed);
    const bool pressed = main_button("Save");
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button("Cancel")) close();
    if (allowed && (pressed || entered)) chosen = {file_, may_keep_state_ && with_state_};
    end_dialog();
    return chosen;
}

UnsavedAnswer unsaved_dialog(bool is_open, const std::string& name) {
    UnsavedAnswer answer = UnsavedAnswer::none;
    if (!begin_dialog("Changes that are not saved", is_open, 30.0F)) return answer;
    coloured_text(colours::text, "\"" + name + "\" was changed and not saved.");
    ImGui::Spacing();
    if (main_button("Save ...")) answer = UnsavedAnswer::save;
    ImGui::SameLine();
    if (ImGui::Button("Lose the changes")) answer = UnsavedAnswer::discard;
    ImGui::SameLine();
    if (ImGui::Button("Go back")) answer = UnsavedAnswer::cancel;
    end_dialog();
    return answer;
}

}  // namespace weft::viewer
