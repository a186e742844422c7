#include "viewer/transport_bar.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace weft::viewer {

namespace {

constexpr std::array speeds{0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 10.0, 25.0, 100.0};
constexpr std::array<const char*, 3> formats{"mp4", "glb", "pc2"};

std::string speed_text(double speed) {
    return fmt::format("{:g}x", speed);
}

void play_buttons(Workbench& bench, const Act& act) {
    const bool playing = bench.playing();
    if (icon_button(playing ? Icon::pause : Icon::play, "play",
                    playing ? "Pause (Space)" : "Go on (Space)", true, colours::accent)) {
        act({Action::pause});
    }
    ImGui::SameLine();
    if (bench.plays_recording()) {
        if (icon_button(Icon::step_back, "back", "One frame back (Left arrow)"))
            act({Action::step_back});
        ImGui::SameLine();
    }
    if (icon_button(Icon::step, "step", "One frame, and pause (Right arrow)")) act({Action::step});
    ImGui::SameLine();
    if (icon_button(Icon::reset, "reset", "Start again (R)")) act({Action::reset});
}

void speed_control(Workbench& bench) {
    ImGui::SetNextItemWidth(5.0F * em());
    if (ImGui::BeginCombo("##speed", speed_text(bench.speed()).c_str(),
                          ImGuiComboFlags_HeightLargest)) {
        for (const double speed : speeds) {
            if (ImGui::Selectable(speed_text(speed).c_str(), speed == bench.speed())) {
                bench.set_speed(speed);
            }
        }
        ImGui::EndCombo();
    }
    tooltip_of_last("Simulated seconds a second (+ and -)");
}

void time_text(Workbench& bench) {
    ImGui::AlignTextToFramePadding();
    if (bench.plays_recording()) {
        Playback& playback = bench.playback();
        ImGui::Text("%.2f s   frame %zu of %zu",
                    static_cast<double>(playback.frame_index()) / playback.frames_per_second(),
                    playback.frame_index(), playback.frame_count() - 1);
        return;
    }
    const FlightView& view = bench.view();
    const FrameBuffer& frame = view.lanes.front().frame;
    ImGui::Text("%.2f s   frame %zu", frame.time, frame.index);
    if (!falls_behind(view)) return;
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, colours::trouble);
    ImGui::Text("reaches %.2gx", view.reached_speed);
    ImGui::PopStyleColor();
    tooltip_of_last("This machine cannot do more.");
}

void timeline(Workbench& bench) {
    Playback& playback = bench.playback();
    int frame = static_cast<int>(playback.frame_index());
    const int last = static_cast<int>(playback.frame_count()) - 1;
    bool loop = playback.loop();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - tick_width("again and again"));
    ImGui::PushStyleColor(ImGuiCol_SliderGrab, colours::accent);
    ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, colours::accent);
    if (ImGui::SliderInt("##timeline", &frame, 0, std::max(last, 1), "",
                         ImGuiSliderFlags_NoInput)) {
        playback.play(false);
        playback.seek(static_cast<std::size_t>(std::max(frame, 0)));
    }
    ImGui::PopStyleColor(2);
    ImGui::SameLine();
    if (ImGui::Checkbox("again and again", &loop)) playback.set_loop(loop);
}

void record_controls(Workbench& bench, WindowSettings& settings, const Act& act,
                     const std::function<void(const std::string&)>& open) {
    const RecordingView& recording = bench.view().recording;
    ImGui::BeginDisabled(recording.active);
    ImGui::SetNextItemWidth(4.6F * em());
    if (ImGui::BeginCombo("##format", settings.recording_format.c_str())) {
        for (const char* format : formats) {
            if (ImGui::Selectable(format, settings.recording_format == format)) {
                settings.recording_format = format;
            }
        }
        ImGui::EndCombo();
    }
    ImGui::EndDisabled();
    tooltip_of_last("What to record to, in the directory where weft was started");
    ImGui::SameLine();
    if (icon_button(recording.active ? Icon::stop : Icon::record, "record",
                    recording.active ? "Stop recording (F9)" : "Record from here (F9)", true,
                    colours::trouble)) {
        act({Action::record});
    }
    if (recording.active) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::Text("%zu frames", recording.frames);
    } else if (recording.ending) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("writing ...");
    } else if (!bench.playable().empty()) {
        ImGui::SameLine();
        if (text_button("Play it back")) open(bench.playable().string());
        tooltip_of_last(bench.playable().filename().string());
    }
}

// Those at the right end of the bar.
void other_buttons(const Act& act) {
    const float width = 2.0F * icon_width() + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
    if (icon_button(Icon::camera, "screenshot", "Screenshot (F12)")) act({Action::screenshot});
    ImGui::SameLine();
    if (icon_button(Icon::help, "help", "Keys and mouse (F1)")) act({Action::help});
}

}  // namespace

double next_speed(double present, bool faster) {
    if (faster) {
        const auto next = std::find_if(speeds.begin(), speeds.end(),
                                       [present](double speed) { return speed > 1.001 * present; });
        return next == speeds.end() ? speeds.back() : *next;
    }
    const auto next = std::find_if(speeds.rbegin(), speeds.rend(),
                                   [present](double speed) { return speed < 0.999 * present; });
    return next == speeds.rend() ? speeds.front() : *next;
}

void transport_bar(const WindowLayout& layout, Workbench& bench, WindowSettings& settings,
                   const Act& act, const std::function<void(const std::string&)>& open) {
    if (begin_panel("Bar", layout.bar, false)) {
        const bool recording = bench.plays_recording();
        if (recording) timeline(bench);
        play_buttons(bench, act);
        ImGui::SameLine(0.0F, em());
        speed_control(bench);
        ImGui::SameLine(0.0F, em());
        time_text(bench);
        if (!recording) {
            // In two rows, the recording's part begins the second.
            if (!layout.two_rows) ImGui::SameLine(0.0F, 1.5F * em());
            record_controls(bench, settings, act, open);
        } else {
            ImGui::SameLine(0.0F, 1.5F * em());
            if (text_button("Open")) act({Action::open});
        }
        other_buttons(act);
    }
    end_panel();
}

}  // namespace weft::viewer
