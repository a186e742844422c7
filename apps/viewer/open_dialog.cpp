#include "viewer/open_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "io/recording_file.h"
#include "viewer/controls.h"
#include "viewer/dialog_frame.h"
#include "weft/error.h"

namespace weft::viewer {

namespace fs = std::filesystem;

std::vector<std::string> openable_entries(const fs::path& directory) {
    std::vector<std::string> directories, files;
    std::error_code unreadable;
    for (fs::directory_iterator entry(directory, unreadable), end; entry != end && !unreadable;
         entry.increment(unreadable)) {
        const std::string name = entry->path().filename().string();
        std::error_code gone;
        if (name.starts_with('.')) continue;
        if (entry->is_directory(gone)) {
            directories.push_back(name + "/");
        } else if (entry->path().extension() == ".toml" || is_recording(entry->path())) {
            files.push_back(name);
        }
    }
    std::sort(directories.begin(), directories.end());
    std::sort(files.begin(), files.end());
    directories.insert(directories.end(), files.begin(), files.end());
    return directories;
}

void OpenDialog::open() {
    is_open_ = true;
    complaint_.clear();
    path_.clear();
    try {
        shipped_ = shipped_scenes();
    } catch (const Error& error) {
        shipped_.clear();
        complaint_ = error.what();
    }
    std::error_code gone;
    if (directory_.empty()) directory_ = fs::current_path(gone);
    list_directory();
}

void OpenDialog::list_directory() {
    entries_ = openable_entries(directory_);
}

std::optional<std::string> OpenDialog::draw(const WindowSettings& settings) {
    std::optional<std::string> chosen;
    if (!begin_dialog("Open a scene or a recording", is_open_, 44.0F)) return chosen;
    const float height = 15.0F * em();
    const float width = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::BeginChild("scenes", {width, height})) {
        draw_shipped(chosen);
        draw_recent(settings, chosen);
    }
    ImGui::EndChild();
    ImGui::SameLine();
    if (ImGui::BeginChild("files", {width, height})) draw_files(chosen);
    ImGui::EndChild();
    take_keyboard();
    const bool entered = ImGui::InputTextWithHint("##path", "path of a scene, .pc2, .mdd or .glb",
                                                  &path_, ImGuiInputTextFlags_EnterReturnsTrue);
    if (!complaint_.empty()) coloured_text(colours::trouble, complaint_);
    if (entered && !path_.empty()) chosen = path_;
    if (main_button("Open") && !path_.empty()) chosen = path_;
    ImGui::SameLine();
    if (ImGui::Button("Cancel")) close();
    end_dialog();
    return chosen;
}

void OpenDialog::draw_shipped(std::optional<std::string>& chosen) {
    ImGui::TextDisabled("Shipped scenes");
    for (const ShippedScene& scene : shipped_) {
        if (ImGui::Selectable((scene.title + "##" + scene.name).c_str())) chosen = scene.name;
        tooltip_of_last(scene.path.string());
    }
}

void OpenDialog::draw_recent(const WindowSettings& settings, std::optional<std::string>& chosen) {
    if (settings.recent.empty()) return;
    ImGui::Spacing();
    ImGui::TextDisabled("Of late");
    for (const std::string& file : settings.recent) {
        const std::string name = fs::path(file).filename().string();
        if (ImGui::Selectable((name + "##recent" + file).c_str())) chosen = file;
        tooltip_of_last(file);
    }
}

void OpenDialog::draw_files(std::optional<std::string>& chosen) {
    ImGui::PushStyleColor(ImGuiCol_Text, colours::faint);
    ImGui::TextUnformatted(directory_.filename().empty() ? directory_.c_str()
                                                         : directory_.filename().c_str());
    ImGui::PopStyleColor();
    tooltip_of_last(directory_.string());
    fs::path next;
    if (directory_.has_relative_path() && ImGui::Selectable("../")) next = directory_.parent_path();
    for (const std::string& entry : entries_) {
        if (!ImGui::Selectable(entry.c_str())) continue;
        if (entry.back() == '/') {
            next = directory_ / entry.substr(0, entry.size() - 1);
        } else {
            chosen = (directory_ / entry).string();
        }
    }
    if (next.empty()) return;
    directory_ = next;
    list_directory();
}

}  // namespace weft::viewer
