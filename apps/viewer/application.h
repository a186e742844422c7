// The window's application: what is open, what is drawn of it, and what keys and buttons do.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <string>

#include "viewer/change_panel.h"
#include "viewer/cloth_view.h"
#include "viewer/glfw_window.h"
#include "viewer/know_panel.h"
#include "viewer/open_dialog.h"
#include "viewer/save_dialog.h"
#include "viewer/window.h"
#include "viewer/workbench.h"

namespace weft::viewer {

class Application {
public:
    /// @throws Error as run_window().
    explicit Application(const WindowRequest& request);
    ~Application();

    WindowReport run();  ///< until the window is closed

private:
    // application.cpp: the loop and the picture
    void look_at_clock();
    [[nodiscard]] double patience() const;
    void draw();
    void draw_cloths(const WindowLayout& layout);
    void draw_panels(const WindowLayout& layout);
    void draw_dialogs();
    void update_title();
    void note_frame();
    [[nodiscard]] WindowMeasures measures() const;
    [[nodiscard]] WindowReport report() const;

    // application_actions.cpp: what is done
    TouchRequests touch_requests();
    void take_input();
    void act(BoundAction action, bool repeated = false);
    void act_on_scene(BoundAction action);
    void quit();  ///< asks first about changes that would be lost
    void escape();
    /// Asks first about changes that would be lost. @param path_or_name empty: asks what.
    void open(const std::string& path_or_name);
    void open_now(const std::string& path_or_name);
    void save(const SaveChoice& choice);
    void take_unsaved_answer(UnsavedAnswer answer);
    void toggle_recording();
    void take_screenshot();  ///< of what was drawn and is not shown yet
    void note_screenshot();  ///< waits for it
    [[nodiscard]] bool in_dialog() const;

    bool (*interrupted_)() = nullptr;
    WindowSettings settings_;
    GlfwWindow window_;
    Workbench bench_;
    ClothView cloths_;
    ChangePanel change_panel_;
    OpenDialog open_dialog_;
    SaveDialog save_dialog_;
    bool help_ = false, closing_ = false;
    bool screenshot_wanted_ = false;
    bool says_something_ = false;  ///< messages are shown
    /// What waits for the answer about unsaved changes.
    std::function<void()> after_unsaved_;
    std::future<std::string> screenshot_;  ///< being written; why it failed, or nothing
    std::filesystem::path screenshot_file_;

    bool news_ = true;    ///< the next frame may differ from the last
    int frames_due_ = 3;  ///< ImGui answers some inputs a frame later
    Clock::time_point started_ = Clock::now(), last_frame_{}, last_event_ = Clock::now();
    Clock::time_point rested_event_ = last_event_;  ///< after which the mouse was seen to rest
    Durations intervals_;                           ///< between frames that followed each other
    std::size_t frames_drawn_ = 0;
};

}  // namespace weft::viewer
