#include "viewer/glfw_window.h"

#include <epoxy/gl.h>
// After epoxy, which stands for the system's OpenGL header.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "weft/error.h"

namespace weft::viewer {

namespace {

constexpr int frames_of_opening = 5;
constexpr int smallest_width = 480, smallest_height = 320;

[[noreturn]] void throw_no_window(const std::string& what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw Error(ErrorKind::file, {}, what + ": " + (reason != nullptr ? reason : "unknown reason"),
                "To make pictures without a window: weft render SCENE -o FILE");
}

// A window that was closed on a display that is gone would open where nobody sees it.
bool is_on_a_monitor(int left, int top) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    for (int k = 0; k < count; ++k) {
        int x = 0, y = 0, width = 0, height = 0;
        glfwGetMonitorWorkarea(monitors[k], &x, &y, &width, &height);
        if (left >= x && top >= y && left < x + width - 50 && top < y + height - 50) return true;
    }
    return false;
}

// Whether a text field has the keyboard. io.WantTextInput still says so a frame after its end.
bool is_typing() {
    const ImGuiContext& imgui = *ImGui::GetCurrentContext();
    return imgui.ActiveId != 0 && imgui.ActiveId == imgui.InputTextState.ID;
}

double monitor_refresh_rate() {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    return mode != nullptr && mode->refreshRate >= 24 ? mode->refreshRate : 60.0;
}

}  // namespace

// What GLFW calls, each handed on to ImGui as well.
struct WindowEvents {
    static GlfwWindow& of(GLFWwindow* window) {
        return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
    }
    static void key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
        ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, modifiers);
        of(window).note_input();
        const bool writes = key != GLFW_KEY_ESCAPE && (key < GLFW_KEY_F1 || key > GLFW_KEY_F25);
        if (action == GLFW_RELEASE || (writes && is_typing())) return;
        of(window).keys_.push_back({key, (modifiers & GLFW_MOD_CONTROL) != 0,
                                    (modifiers & GLFW_MOD_SHIFT) != 0, action == GLFW_REPEAT});
    }
    static void character(GLFWwindow* window, unsigned code) {
        ImGui_ImplGlfw_CharCallback(window, code);
        of(window).note_input();
    }
    static void button(GLFWwindow* window, int button, int action, int modifiers) {
        ImGui_ImplGlfw_MouseButtonCallback(window, button, action, modifiers);
        of(window).note_input();
    }
    static void move(GLFWwindow* window, double, double) { of(window).note_input(); }
    static void enter(GLFWwindow* window, int entered) {
        ImGui_ImplGlfw_CursorEnterCallback(window, entered);
        of(window).note_input();
    }
    static void focus(GLFWwindow* window, int focused) {
        ImGui_ImplGlfw_WindowFocusCallback(window, focused);
        of(window).note_input();
    }
    static void scroll(GLFWwindow* window, double right, double up) {
        ImGui_ImplGlfw_ScrollCallback(window, right, up);
        of(window).note_input();
    }
    static void resize(GLFWwindow* window, int, int) { of(window).note_input(); }
    static void refresh(GLFWwindow* window) { of(window).note_input(); }
    static void close(GLFWwindow* window) { of(window).note_input(); }
    static void drop(GLFWwindow* window, int count, const char** paths) {
        of(window).dropped_.assign(paths, paths + count);
        of(window).note_input();
    }
    static void listen(GLFWwindow* window) {
        glfwSetKeyCallback(window, key);
        glfwSetCharCallback(window, character);
        glfwSetMouseButtonCallback(window, button);
        glfwSetCursorPosCallback(window, move);
        glfwSetCursorEnterCallback(window, enter);
        glfwSetWindowFocusCallback(window, focus);
        glfwSetScrollCallback(window, scroll);
        glfwSetFramebufferSizeCallback(window, resize);
        glfwSetWindowRefreshCallback(window, refresh);
        glfwSetWindowCloseCallback(window, close);
        glfwSetDropCallback(window, drop);
    }
};

GlfwWindow::GlfwWindow(const WindowSettings& settings) {
    if (glfwInit() == GLFW_FALSE) throw_no_window("no display");
    try {
        open(settings);
    } catch (...) {
        glfwTerminate();
        throw;
    }
    start_imgui();
}

void GlfwWindow::open(const WindowSettings& settings) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    // Cloths of one sample a pixel are drawn straight into the window; those of several come from a
    // framebuffer of their own, which no window with samples could take.
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_MAXIMIZED, settings.maximised ? GLFW_TRUE : GLFW_FALSE);
    const bool first_time = settings.position[0] < 0;
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, first_time ? GLFW_TRUE : GLFW_FALSE);
    title_ = "weft";
    window_ =
        glfwCreateWindow(settings.size[0], settings.size[1], title_.c_str(), nullptr, nullptr);
    if (window_ == nullptr) throw_no_window("no window with OpenGL 3.3");
    if (!first_time && is_on_a_monitor(settings.position[0], settings.position[1])) {
        glfwSetWindowPos(window_, settings.position[0], settings.position[1]);
    }
    glfwSetWindowSizeLimits(window_, smallest_width, smallest_height, GLFW_DONT_CARE,
                            GLFW_DONT_CARE);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    refresh_rate_ = monitor_refresh_rate();
    glfwSetWindowUserPointer(window_, this);
    WindowEvents::listen(window_);
}

void GlfwWindow::start_imgui() {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    float scale = 1.0F;
    glfwGetWindowContentScale(window_, &scale, nullptr);
    fonts_ = apply_theme(std::clamp(scale, 0.5F, 4.0F), pixels_per_unit());
    ImGui_ImplGlfw_InitForOpenGL(window_, false);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

GlfwWindow::~GlfwWindow() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void GlfwWindow::note_input() {
    if (!input_since_) input_since_ = Clock::now();
}

void GlfwWindow::wait(double seconds) {
    if (seconds > 0.0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
}

std::vector<KeyPress> GlfwWindow::take_keys() {
    return std::exchange(keys_, {});
}

std::vector<std::string> GlfwWindow::take_dropped_files() {
    return std::exchange(dropped_, {});
}

bool GlfwWindow::asked_to_close() {
    const bool asked = glfwWindowShouldClose(window_) != GLFW_FALSE;
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
    return asked;
}

void GlfwWindow::begin_frame() {
    answered_input_ = std::exchange(input_since_, std::nullopt);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    const FramebufferSize size = framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
    glClearColor(0.102F, 0.118F, 0.161F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

void GlfwWindow::draw_imgui() {
    ImGui::Render();
    const FramebufferSize size = framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void GlfwWindow::end_frame() {
    glfwSwapBuffers(window_);
    // The first frames compile shaders, and the inputs they answer are those of the window opening.
    if (frames_shown_ < frames_of_opening) ++frames_shown_;
    if (!answered_input_ || frames_shown_ < frames_of_opening) return;
    glFinish();  // else the time would be that of handing the work over
    latencies_.add(seconds_between(*answered_input_, Clock::now()));
}

Image GlfwWindow::read_pixels() const {
    const FramebufferSize size = framebuffer();
    Image image{size.width, size.height, {}};
    const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(size.width);
    image.rgba.resize(static_cast<std::size_t>(row * size.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    // OpenGL's rows go upward, those of an Image downward.
    auto top = image.rgba.begin();
    for (auto bottom = image.rgba.end() - row; top < bottom; top += row, bottom -= row)
        std::swap_ranges(top, top + row, bottom);
    for (std::size_t k = 3; k < image.rgba.size(); k += 4) image.rgba[k] = 255;
    return image;
}

void GlfwWindow::set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_, title.c_str());
}

void GlfwWindow::store(WindowSettings& settings) const {
    settings.maximised = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) != GLFW_FALSE;
    if (settings.maximised) return;  // keeps the size to go back to
    glfwGetWindowSize(window_, &settings.size[0], &settings.size[1]);
    glfwGetWindowPos(window_, &settings.position[0], &settings.position[1]);
}

GlfwWindow::FramebufferSize GlfwWindow::framebuffer() const {
    FramebufferSize size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return size;
}

float GlfwWindow::pixels_per_unit() const {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    if (width <= 0) return 1.0F;  // minimised
    return static_cast<float>(framebuffer().width) / static_cast<float>(width);
}

}  // namespace weft::viewer
