// What keys, buttons and the mouse do.
#include <imgui.h>

#include <chrono>
#include <utility>

#include "io/output_file.h"
#include "io/picture_recorder.h"
#include "io/recording_file.h"
#include "viewer/application.h"
#include "viewer/compare_section.h"
#include "viewer/file_names.h"
#include "viewer/obstacle_placing.h"
#include "viewer/scene_edits.h"
#include "viewer/transport_bar.h"
#include "weft/error.h"

namespace weft::viewer {

namespace {

// What an action shows or hides; null: it does something else.
bool* switch_of(Action action, WindowSettings& settings) {
    switch (action) {
        case Action::wireframe:
            return &settings.wireframe;
        case Action::panels:
            return &settings.panels;
        case Action::particles:
            return &settings.particles;
        case Action::normals:
            return &settings.normals;
        case Action::wind_arrows:
            return &settings.wind_arrows;
        default:
            return nullptr;
    }
}

// Only where one wants more of the same.
bool goes_on_while_held(Action action) {
    return action == Action::step || action == Action::step_back || action == Action::undo ||
           action == Action::redo;
}

}  // namespace

TouchRequests Application::touch_requests() {
    TouchRequests requests;
    requests.grip = [this](std::size_t cloth, std::vector<Grip> grips) {
        if (!bench_.plays_recording()) bench_.flight().set_grips(cloth, std::move(grips));
    };
    requests.toggle_pin = [this](std::size_t particle, Vec3d present) {
        try {
            const Vec3d offset = present - rest_position(bench_.scene(), particle);
            bench_.edit(with_pin_toggled(bench_.scene(), particle, offset), "pin");
        } catch (const Error& error) {
            bench_.messages.add(MessageKind::trouble, error.what());
        }
        bench_.end_gesture();
    };
    requests.move_pin = [this](std::size_t particle, Vec3d shift) {
        bench_.edit(with_pin_moved(bench_.scene(), particle, shift), "pin's place");
    };
    requests.move_obstacle = [this](std::size_t obstacle, Vec3d shift) {
        bench_.edit(with_obstacle_moved(bench_.scene(), obstacle, shift), "obstacle's place");
    };
    requests.gesture_ended = [this] { bench_.end_gesture(); };
    return requests;
}

bool Application::in_dialog() const {
    return open_dialog_.is_open() || save_dialog_.is_open() || static_cast<bool>(after_unsaved_);
}

void Application::take_input() {
    for (const KeyPress& press : window_.take_keys()) {
        const auto action = action_of(press.key, press.control, press.shift);
        if (!action) continue;
        const bool harmless =
            action->action == Action::escape || action->action == Action::screenshot;
        if (in_dialog() && !harmless) continue;
        act(*action, press.repeated);
    }
    for (const std::string& file : window_.take_dropped_files()) {
        if (!in_dialog()) open(file);
    }
    if (window_.asked_to_close()) act({Action::quit});
    using namespace std::chrono_literals;
    if (screenshot_.valid() && screenshot_.wait_for(0s) == std::future_status::ready) {
        note_screenshot();
    }
}

void Application::act(BoundAction action, bool repeated) {
    news_ = true;
    if (repeated && !goes_on_while_held(action.action)) return;
    if (bool* shown = switch_of(action.action, settings_)) {
        *shown = !*shown;
        return;
    }
    switch (action.action) {
        case Action::pause:
            return bench_.toggle_play();
        case Action::step:
            return bench_.step(1);
        case Action::step_back:
            return bench_.step(-1);
        case Action::reset:
            return bench_.reset();
        case Action::frame_cloth:
            return cloths_.frame_cloth();
        case Action::help:
            help_ = !help_;
            return;
        case Action::screenshot:
            screenshot_wanted_ = true;
            return;
        case Action::escape:
            return escape();
        case Action::open:
            return open({});
        case Action::quit:
            return quit();
        case Action::faster:
        case Action::slower:
            return bench_.set_speed(next_speed(bench_.speed(), action.action == Action::faster));
        case Action::springs:
            settings_.springs = (settings_.springs + 1) % 3;
            return;
        default:
            if (!bench_.plays_recording()) act_on_scene(action);
    }
}

void Application::act_on_scene(BoundAction action) {
    const auto add = [this](const ObstacleDescription& obstacle) {
        bench_.edit(with_obstacle(bench_.scene(), obstacle), "obstacle");
        bench_.end_gesture();
    };
    const FrameBuffer& frame = bench_.view().lanes.front().frame;
    switch (action.action) {
        case Action::choose_method: {
            const auto methods = numbered_methods();
            const auto number = static_cast<std::size_t>(action.number);
            if (number >= 1 && number <= methods.size()) bench_.set_method(methods[number - 1]);
            return;
        }
        case Action::undo:
            return bench_.undo();
        case Action::redo:
            return bench_.redo();
        case Action::save:
            return save_dialog_.open(bench_.suggested_file(), !bench_.view().pristine);
        case Action::record:
            return toggle_recording();
        case Action::add_sphere:
            return add(sphere_beside(frame.positions));
        case Action::add_plane:
            return add(plane_below(frame.positions));
        case Action::compare:
            return toggle_comparison(bench_);
        default:
            return;
    }
}

void Application::quit() {
    if (!bench_.unsaved()) {
        closing_ = true;
    } else if (!after_unsaved_) {
        after_unsaved_ = [this] { closing_ = true; };
    }
}

// Closes the topmost thing that is open; else lets go of what is held.
void Application::escape() {
    if (help_) {
        help_ = false;
    } else if (save_dialog_.is_open()) {
        save_dialog_.close();
        after_unsaved_ = nullptr;
    } else if (after_unsaved_) {
        after_unsaved_ = nullptr;
    } else if (open_dialog_.is_open()) {
        open_dialog_.close();
    } else {
        cloths_.cancel_gesture();
        bench_.messages.dismiss();
    }
}

void Application::open(const std::string& path_or_name) {
    if (path_or_name.empty()) {
        open_dialog_.open();
    } else if (bench_.unsaved() && !is_recording(path_or_name)) {
        open_dialog_.close();
        after_unsaved_ = [this, path_or_name] { open_now(path_or_name); };
    } else {
        open_now(path_or_name);
    }
}

void Application::open_now(const std::string& path_or_name) {
    try {
        bench_.open(path_or_name);
        open_dialog_.close();
        cloths_.cancel_gesture();
        cloths_.reset_camera();
        news_ = true;
    } catch (const Error& error) {
        bench_.messages.add(MessageKind::trouble, error.what());
        open_dialog_.complain(error.what());
    }
}

void Application::save(const SaveChoice& choice) {
    try {
        bench_.save(choice.file, choice.with_state);
        save_dialog_.close();
        if (const auto go_on = std::exchange(after_unsaved_, nullptr)) go_on();
    } catch (const Error& error) {
        save_dialog_.complain(error.what());
    }
}

void Application::take_unsaved_answer(UnsavedAnswer answer) {
    if (answer == UnsavedAnswer::none) return;
    if (answer == UnsavedAnswer::save) {
        save_dialog_.open(bench_.suggested_file(), !bench_.view().pristine);
    } else {
        const auto go_on = std::exchange(after_unsaved_, nullptr);
        if (answer == UnsavedAnswer::discard && go_on) go_on();
    }
}

void Application::toggle_recording() {
    if (bench_.recording()) return bench_.stop_recording();
    RenderDescription render = bench_.render();
    const Camera& camera = cloths_.camera();
    render.camera = Vec3d{camera.eye.x, camera.eye.y, camera.eye.z};
    render.target = Vec3d{camera.target.x, camera.target.y, camera.target.z};
    render.field_of_view = camera.field_of_view;
    bench_.start_recording(settings_.recording_format, render);
}

// Packing a picture takes several frames' time: it is done beside.
void Application::take_screenshot() {
    screenshot_wanted_ = false;
    if (screenshot_.valid()) note_screenshot();
    screenshot_file_ =
        numbered_file(std::filesystem::current_path(), "weft-" + bench_.stem(), "png");
    screenshot_ =
        std::async(std::launch::async, [image = window_.read_pixels(), path = screenshot_file_] {
            try {
                OutputFile file(path);
                write_png(file, image);
            } catch (const std::exception& error) {
                return std::string(error.what());
            }
            return std::string();
        });
}

void Application::note_screenshot() {
    const std::string error = screenshot_.get();
    if (error.empty()) {
        bench_.wrote(screenshot_file_);
        bench_.messages.add(MessageKind::done,
                            "Screenshot: " + screenshot_file_.filename().string());
    } else {
        bench_.messages.add(MessageKind::trouble, error);
    }
    news_ = true;
}

}  // namespace weft::viewer
