#include "viewer/application.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "viewer/notices.h"
#include "viewer/transport_bar.h"
#include "viewer/value_slider.h"

namespace weft::viewer {

namespace {

constexpr double glance = 0.004;         // between two looks at a flight that moves [s]
constexpr double rest = 0.25;            // between two looks at one that rests
constexpr double attention = 1.0;        // after an input, a flight may answer for so long [s]
constexpr double pause_of_frames = 0.2;  // longer, and two frames did not follow each other [s]
constexpr double rested = 0.7;           // a mouse that rests: longer than tooltips wait [s]
constexpr int frames_after_input = 3;

// What a lane says of itself over its cloth. Its energy is that of the plots, which counts from the
// start.
std::vector<std::string> lane_label(const LaneView& lane, const LaneMeasurements& measured) {
    std::vector<std::string> lines{
        lane.method, fmt::format("{:.2f} s", lane.frame.time),
        fmt::format("step {:.3g} s, {} a frame", lane.time_step, lane.steps_per_frame)};
    if (lane.milliseconds > 0.0) lines.push_back(brief(lane.milliseconds, 3) + " ms a frame");
    lines.push_back("energy " + with_unit(measured.total.values().back(), "J"));
    return lines;
}

}  // namespace

Application::Application(const WindowRequest& request)
    : interrupted_(request.interrupted),
      settings_(load_window_settings(window_settings_path())),
      window_(settings_),
      bench_(request, settings_),
      cloths_(touch_requests()) {}

Application::~Application() = default;

WindowReport Application::run() {
    while (!closing_) {
        window_.wait(patience());
        if (interrupted_ != nullptr && interrupted_()) break;
        if (window_.input_waits()) {
            frames_due_ = frames_after_input;
            last_event_ = Clock::now();
        }
        if (bench_.refresh()) {
            news_ = true;
            // ImGui shows a window that is new, as that of a divergence, a frame later.
            if (!bench_.playing()) frames_due_ = frames_after_input;
            last_event_ = Clock::now();
        }
        take_input();
        look_at_clock();
        if (!news_ && frames_due_ == 0) continue;
        draw();
    }
    if (screenshot_.valid()) note_screenshot();
    window_.store(settings_);
    save_window_settings(settings_, window_settings_path());
    return report();
}

// What changes on the screen because time passes.
void Application::look_at_clock() {
    const double since_frame = seconds_between(last_frame_, Clock::now());
    if (says_something_ && since_frame > rest) news_ = true;  // messages go in the end
    if (last_event_ != rested_event_ && seconds_between(last_event_, Clock::now()) > rested) {
        rested_event_ = last_event_;
        news_ = true;  // a tooltip comes when the mouse rests
    }
}

// How long to wait for events before looking at the flight again.
double Application::patience() const {
    const Clock::time_point now = Clock::now();
    const double since_frame = seconds_between(last_frame_, now);
    const double due = 1.0 / window_.refresh_rate() - since_frame;  // where nothing else paces
    if (news_ || frames_due_ > 0) return std::max(0.0, due);
    const bool watched = bench_.busy() || seconds_between(last_event_, now) < attention;
    return watched ? std::max(glance, due) : rest;
}

void Application::draw() {
    note_frame();
    news_ = false;
    frames_due_ = std::max(0, frames_due_ - 1);
    window_.begin_frame();
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const WindowLayout layout =
        lay_out(size.x, size.y, em(), settings_.panels, bench_.plays_recording());
    draw_cloths(layout);
    draw_panels(layout);
    draw_dialogs();
    says_something_ = message_list(layout.cloth, bench_.messages);
    update_title();
    window_.draw_imgui();
    if (screenshot_wanted_) take_screenshot();
    window_.end_frame();
}

void Application::draw_cloths(const WindowLayout& layout) {
    Shown shown;
    shown.paused = !bench_.playing();
    if (bench_.plays_recording()) {
        Playback& playback = bench_.playback();
        shown.cloths.push_back({playback.shape(), playback.frame(), {}, {}});
        shown.touchable = false;
    } else {
        const FlightView& view = bench_.view();
        for (std::size_t k = 0; k < view.lanes.size(); ++k) {
            const LaneView& lane = view.lanes[k];
            shown.cloths.push_back({lane.shape,
                                    lane.frame.view(),
                                    lane_label(lane, bench_.measurements.lanes()[k]),
                                    {}});
            if (lane.divergence) {
                shown.cloths.back().note = fmt::format(
                    "diverged at step {}, {:.4g} s", lane.divergence->step, lane.divergence->time);
            }
            shown.grip_force += lane.grip_force;
        }
        shown.obstacles = view.scene.obstacles;
        shown.wind = view.wind;
    }
    const float scale = window_.pixels_per_unit();
    const auto pixels = [scale](float units) {
        return static_cast<int>(std::lround(units * scale));
    };
    const ViewArea area{pixels(layout.cloth.left), pixels(layout.cloth.top),
                        pixels(layout.cloth.width), pixels(layout.cloth.height)};
    if (area.width < 1 || area.height < 1) return;
    cloths_.show(shown, settings_, bench_.render(), area, window_.framebuffer().height, scale);
}

void Application::draw_panels(const WindowLayout& layout) {
    const Act act = [this](BoundAction action) { this->act(action); };
    if (layout.change.width > 0.0F && !bench_.plays_recording()) {
        change_panel_.draw(layout.change, bench_, settings_, act);
    } else if (layout.change.width > 0.0F) {
        if (begin_panel("Change", layout.change)) {
            if (text_button("Open")) act({Action::open});
            ImGui::SameLine();
            if (bench_.has_scene() && text_button("Back to the scene")) bench_.return_to_scene();
            ImGui::Spacing();
            see_section(settings_, true);
        }
        end_panel();
    }
    if (layout.know.width > 0.0F) {
        const auto measure = [this] { return measures(); };
        if (bench_.plays_recording()) {
            recording_facts(layout.know, bench_, measure);
        } else {
            know_panel(layout.know, bench_, measure);
        }
    }
    transport_bar(layout, bench_, settings_, act, [this](const std::string& file) { open(file); });
    if (!bench_.plays_recording()) divergence_notice(layout.cloth, bench_);
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left)) bench_.end_gesture();
}

void Application::draw_dialogs() {
    if (const auto chosen = open_dialog_.draw(settings_)) open(*chosen);
    if (const auto choice = save_dialog_.draw()) save(*choice);
    take_unsaved_answer(unsaved_dialog(after_unsaved_ && !save_dialog_.is_open(),
                                       bench_.has_scene() ? bench_.scene().name : ""));
    help_overlay(help_, window_.fonts());
}

void Application::update_title() {
    window_.set_title(
        fmt::format("{} - weft{}", bench_.title(), bench_.playing() ? "" : " - paused"));
}

// At its beginning: what is due then counts from there.
void Application::note_frame() {
    const Clock::time_point now = Clock::now();
    const double interval = seconds_between(last_frame_, now);
    if (frames_drawn_ > 0 && interval < pause_of_frames) intervals_.add(interval);
    last_frame_ = now;
    ++frames_drawn_;
}

WindowMeasures Application::measures() const {
    const double interval = intervals_.median();
    return {interval > 0.0 && bench_.playing() ? 1.0 / interval : 0.0,
            1e3 * window_.latencies().median(), cloths_.quality()};
}

WindowReport Application::report() const {
    WindowReport report;
    report.frames_drawn = frames_drawn_;
    report.seconds = seconds_between(started_, Clock::now());
    report.frames_per_second = intervals_.median() > 0.0 ? 1.0 / intervals_.median() : 0.0;
    report.latency_ms_median = 1e3 * window_.latencies().median();
    report.latency_ms_largest = 1e3 * window_.latencies().largest();
    report.files = bench_.files();
    report.messages = bench_.messages.all();
    if (!bench_.has_scene()) return report;
    const LaneView& lane = bench_.view().lanes.front();
    report.simulation_frame = lane.frame.index;
    report.state_hash = lane.state_hash;
    report.pristine = bench_.view().pristine;
    return report;
}

}  // namespace weft::viewer
