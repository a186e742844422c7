#include "viewer/notices.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "viewer/key_bindings.h"

namespace weft::viewer {

namespace {

constexpr ImGuiWindowFlags still_window =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar |
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize;

const char* remedy_label(Remedy remedy) {
    switch (remedy) {
        case Remedy::stable_step:
            return "Use the stable step";
        case Remedy::half_the_step:
            return "Halve the step";
        case Remedy::other_method:
            return "Let weft choose the method";
    }
    return "";
}

struct HelpRow {
    std::string_view what, meaning;
};

// Keys, then the mouse.
std::vector<HelpRow> help_rows() {
    std::vector<HelpRow> rows;
    for (const KeyBinding& row : key_bindings()) {
        if (!row.keys.empty()) rows.push_back({row.keys, row.meaning});
    }
    for (const MouseBinding& row : mouse_bindings()) rows.push_back({row.gesture, row.meaning});
    return rows;
}

void help_table(const char* id, std::span<const HelpRow> rows, float names) {
    if (!ImGui::BeginTable(id, 2)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, names);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const HelpRow& row : rows) {
        ImGui::TableNextRow();
        for (const auto& [text, colour] :
             {std::pair(row.what, colours::accent), std::pair(row.meaning, colours::text)}) {
            ImGui::TableNextColumn();
            coloured_text(colour, std::string(text));
        }
    }
    ImGui::EndTable();
}

}  // namespace

void divergence_notice(const Place& cloth, Workbench& bench) {
    const LaneView& lane = bench.view().lanes.front();
    if (!lane.divergence) return;
    const float width = std::min(34.0F * em(), cloth.width - 2.0F * em());
    ImGui::SetNextWindowPos({cloth.left + 0.5F * cloth.width, cloth.top + 0.3F * cloth.height},
                            ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSize({width, 0.0F});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(58, 28, 30, 245));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.9F * em(), 0.7F * em()});
    if (ImGui::Begin("Diverged", nullptr, still_window)) {
        coloured_text(colours::trouble, "The cloth blew up");
        coloured_text(colours::text, lane.divergence->message);
        coloured_text(colours::faint, lane.divergence->advice);
        ImGui::Spacing();
        if (main_button(remedy_label(bench.remedy()))) bench.apply_remedy();
        ImGui::SameLine();
        if (ImGui::Button("Reset")) bench.reset();
    }
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

bool message_list(const Place& cloth, Messages& messages) {
    const std::vector<Message>& present = messages.present();
    if (present.empty()) return false;
    // The latest ones, and more of them where they leave most of the cloth to be seen.
    const auto room = static_cast<std::size_t>(std::max(1.0F, cloth.height / (10.0F * em())));
    const std::size_t shown = std::min(present.size(), room);
    const float margin = 0.7F * em();
    ImGui::SetNextWindowPos({cloth.left + 0.5F * cloth.width, cloth.top + cloth.height - margin},
                            ImGuiCond_Always, {0.5F, 1.0F});
    ImGui::SetNextWindowSize({std::min(36.0F * em(), cloth.width - 2.0F * margin), 0.0F});
    ImGui::SetNextWindowBgAlpha(0.92F);
    if (ImGui::Begin("Messages", nullptr, still_window)) {
        for (const Message& message : std::span(present).last(shown)) {
            coloured_text(message.kind == MessageKind::done ? colours::good : colours::trouble,
                          message.text);
        }
        if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
            messages.dismiss();
        }
    }
    ImGui::End();
    return true;
}

void help_overlay(bool& is_open, const Fonts& fonts) {
    if (!is_open) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = std::min(66.0F * em(), 0.97F * screen.x);
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, 0.96F * screen.y});
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {1.2F * em(), 0.9F * em()});
    if (ImGui::Begin("Help", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::PushFont(fonts.heading);
        ImGui::TextUnformatted("Keys and mouse");
        ImGui::PopFont();
        text_at_right("Esc closes this", colours::faint);
        ImGui::Separator();
        const std::vector<HelpRow> rows = help_rows();
        const std::size_t half = (rows.size() + 1) / 2;
        if (ImGui::BeginTable("halves", 2, ImGuiTableFlags_SizingStretchSame)) {
            ImGui::TableNextColumn();
            help_table("first", std::span(rows).first(half), 0.19F * width);
            ImGui::TableNextColumn();
            help_table("second", std::span(rows).subspan(half), 0.19F * width);
            ImGui::EndTable();
        }
        const bool outside = !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows) &&
                             ImGui::IsMouseClicked(ImGuiMouseButton_Left);
        if (outside) is_open = false;
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace weft::viewer
