#include "viewer/know_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <vector>

#include "viewer/line_plot.h"
#include "viewer/value_slider.h"

namespace weft::viewer {

namespace {

constexpr std::array<ImU32, 6> energy_colours{
    IM_COL32(236, 112, 99, 255),  IM_COL32(127, 179, 213, 255), IM_COL32(240, 180, 75, 255),
    IM_COL32(126, 201, 143, 255), IM_COL32(187, 143, 206, 255), IM_COL32(229, 231, 236, 255)};

using SeriesOf = const TimeSeries LaneMeasurements::*;

// One line a lane.
std::vector<PlotLine> of_lanes(const Workbench& bench, SeriesOf which) {
    std::vector<PlotLine> lines;
    const std::vector<LaneMeasurements>& lanes = bench.measurements.lanes();
    for (std::size_t k = 0; k < lanes.size(); ++k) {
        lines.push_back({&(lanes[k].*which), lane_colour(k),
                         lanes.size() > 1 ? bench.view().lanes[k].method : std::string{}});
    }
    return lines;
}

void energy_section(const Workbench& bench) {
    if (!section("Energy", true) || bench.measurements.lanes().empty()) return;
    const LaneMeasurements& lane = bench.measurements.lanes().front();
    const std::array lines{PlotLine{&lane.kinetic, energy_colours[0], "kinetic"},
                           PlotLine{&lane.gravity, energy_colours[1], "gravity"},
                           PlotLine{&lane.structural, energy_colours[2], "structural"},
                           PlotLine{&lane.shear, energy_colours[3], "shear"},
                           PlotLine{&lane.bend, energy_colours[4], "bend"},
                           PlotLine{&lane.total, energy_colours[5], "total"}};
    line_plot({.title = bench.view().lanes.front().method, .unit = "J", .height = 6.0F}, lines);
    coloured_text(colours::faint, "Gravity counts from the start.");
    if (bench.view().lanes.size() < 2) return;
    line_plot({.title = "Total energy", .unit = "J", .height = 4.0F},
              of_lanes(bench, &LaneMeasurements::total));
}

void speed_section(const Workbench& bench) {
    if (!section("Strain and speed", true)) return;
    const LaneView& lane = bench.view().lanes.front();
    line_plot({.title = "Largest strain",
               .present = brief(100.0 * lane.largest_strain.strain, 3) + " %",
               .unit = "%"},
              of_lanes(bench, &LaneMeasurements::strain));
    line_plot(
        {.title = "Steps a second", .present = brief(steps_per_second(lane), 3), .unit = "1/s"},
        of_lanes(bench, &LaneMeasurements::steps_per_second));
    line_plot(
        {.title = "A frame takes", .present = brief(lane.milliseconds, 3) + " ms", .unit = "ms"},
        of_lanes(bench, &LaneMeasurements::milliseconds));
}

void speed_fact(const FlightView& view) {
    if (!view.playing || view.reached_speed <= 0.0) {
        fact("speed", fmt::format("{:g}x, resting", view.speed));
        return;
    }
    const bool slow = falls_behind(view);
    fact("speed", fmt::format("{:.2f}x of real time", view.reached_speed),
         slow ? colours::trouble : colours::text);
    if (slow) coloured_text(colours::trouble, "This machine cannot do more.");
}

void step_facts(const LaneView& lane) {
    const bool beyond = lane.time_step > lane.stable_step;
    fact("time step", with_unit(lane.time_step, "s"), beyond ? colours::trouble : colours::text);
    fact("stable up to", lane.stable_step > 0.0 ? with_unit(lane.stable_step, "s") : "no step");
    fact("steps a frame", std::to_string(lane.steps_per_frame));
}

void spring_fact(const ClothShape& shape) {
    std::array<std::size_t, 3> counts{};
    for (const DrawnSpring& spring : shape.springs) ++counts[spring.kind];
    fact("springs", std::to_string(shape.springs.size()));
    tooltip_of_last(
        fmt::format("{} structural, {} shear, {} bend", counts[0], counts[1], counts[2]));
}

void hash_fact(const LaneView& lane, bool pristine) {
    const std::string hash = fmt::format("{:016x}", lane.state_hash);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("state hash");
    const float width = ImGui::CalcTextSize(hash.c_str()).x;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
    if (ImGui::Selectable(hash.c_str(), false, 0, {width, 0.0F})) {
        ImGui::SetClipboardText(hash.c_str());
    }
    tooltip_of_last("Of the bits of all positions and velocities. Click: copies it.");
    fact("flown", pristine ? "from the scene alone" : "changed since the start",
         pristine ? colours::good : colours::accent);
    tooltip_of_last(pristine ? "weft run of the saved scene comes to the same state hash."
                             : "Something was changed, held or moved while it flew. Reset flies "
                               "the scene as it now is from its start.");
}

void cloth_section(const Workbench& bench) {
    if (!section("State", true)) return;
    const FlightView& view = bench.view();
    const LaneView& lane = view.lanes.front();
    fact("method", lane.method);
    if (!lane.method_reason.empty()) tooltip_of_last(lane.method_reason);
    step_facts(lane);
    speed_fact(view);
    const std::size_t particles = lane.shape->surface.particle_count;
    fact("particles", fmt::format("{}, {} pinned", particles, lane.shape->pinned.size()));
    spring_fact(*lane.shape);
    fact("mass", with_unit(lane.shape->mass, "kg"));
    hash_fact(lane, view.pristine);
    if (!lane.method_reason.empty()) coloured_text(colours::faint, lane.method_reason);
    for (const std::string& warning : lane.warnings) coloured_text(colours::accent, warning);
}

void window_section(const std::function<WindowMeasures()>& measure) {
    if (!section("Window", false)) return;
    const WindowMeasures window = measure();
    fact("frames drawn", window.frames_per_second > 0.0
                             ? fmt::format("{:.0f} a second", window.frames_per_second)
                             : "resting");
    fact("answers an input in", fmt::format("{:.0f} ms", window.latency_ms));
    coloured_text(colours::faint, window.quality);
}

}  // namespace

void know_panel(const Place& place, const Workbench& bench,
                const std::function<WindowMeasures()>& measure) {
    if (begin_panel("Know", place)) {
        energy_section(bench);
        speed_section(bench);
        cloth_section(bench);
        window_section(measure);
    }
    end_panel();
}

void recording_facts(const Place& place, Workbench& bench,
                     const std::function<WindowMeasures()>& measure) {
    if (begin_panel("Know", place)) {
        Playback& playback = bench.playback();
        if (section("Recording", true)) {
            fact("frames", std::to_string(playback.frame_count()));
            fact("a second", with_unit(playback.frames_per_second(), ""));
            fact("lasts", with_unit(static_cast<double>(playback.frame_count() - 1) /
                                        playback.frames_per_second(),
                                    "s"));
            fact("particles", std::to_string(playback.shape()->surface.particle_count));
            fact("triangles", std::to_string(playback.shape()->surface.triangles.size()));
            coloured_text(colours::faint, playback.path().string());
        }
        window_section(measure);
    }
    end_panel();
}

}  // namespace weft::viewer
