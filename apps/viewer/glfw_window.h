// A window of the display, with OpenGL 3.3 and ImGui in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/image.h"
#include "viewer/frame_times.h"
#include "viewer/theme.h"
#include "viewer/window_settings.h"

struct GLFWwindow;

namespace weft::viewer {

/// A key that went down while no text field wanted it.
struct KeyPress {
    int key = 0;  ///< GLFW's code
    bool control = false, shift = false;
    bool repeated = false;  ///< by being held down
};

/// One at a time.
class GlfwWindow {
public:
    /// @throws Error (file) where there is no display or no OpenGL 3.3.
    explicit GlfwWindow(const WindowSettings& settings);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    /// Waits for an event, at most so long [s]; 0: takes those that have come.
    void wait(double seconds);
    /// Whether anything came since the last frame that the picture may answer.
    [[nodiscard]] bool input_waits() const { return input_since_.has_value(); }
    std::vector<KeyPress> take_keys();
    std::vector<std::string> take_dropped_files();
    [[nodiscard]] bool asked_to_close();  ///< once for each time

    void begin_frame();
    void draw_imgui();                        ///< over what was drawn so far
    void end_frame();                         ///< shows all
    [[nodiscard]] Image read_pixels() const;  ///< the framebuffer as it now is

    void set_title(const std::string& title);
    void store(WindowSettings& settings) const;  ///< size and place
    [[nodiscard]] const Fonts& fonts() const { return fonts_; }
    [[nodiscard]] double refresh_rate() const { return refresh_rate_; }  ///< of the display [1/s]
    struct FramebufferSize {
        int width = 0, height = 0;  ///< [pixels]
    };
    [[nodiscard]] FramebufferSize framebuffer() const;
    [[nodiscard]] float pixels_per_unit() const;  ///< of the framebuffer, a screen unit
    /// From the moment an input was taken from the system to that at which its frame was shown; not
    /// while the window opens.
    [[nodiscard]] const Durations& latencies() const { return latencies_; }

private:
    friend struct WindowEvents;
    void open(const WindowSettings& settings);
    void start_imgui();
    void note_input();

    GLFWwindow* window_ = nullptr;
    Fonts fonts_;
    double refresh_rate_ = 60.0;
    std::optional<Clock::time_point> input_since_, answered_input_;
    Durations latencies_;
    int frames_shown_ = 0;  ///< while the window opens
    std::vector<KeyPress> keys_;
    std::vector<std::string> dropped_;
    std::string title_;
};

}  // namespace weft::viewer
