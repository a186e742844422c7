// An OpenGL 3.3 core context without window or display, through EGL.
#pragma once

#include <memory>

namespace weft {

/// Owns an OpenGL 3.3 core context that has no surface: it draws into framebuffer objects only. It
/// is current in no thread until a CurrentContext says so.
class GlContext {
public:
    /// @throws Error (file) where EGL or a driver is missing, naming the step that failed.
    GlContext();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

private:
    friend class CurrentContext;
    struct State;
    std::unique_ptr<State> state_;
};

/// Makes a context current in this thread while it lives; then the earlier one is current again.
class CurrentContext {
public:
    /// @throws Error (file) where the context is current in another thread.
    explicit CurrentContext(const GlContext& context);
    ~CurrentContext();
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;

private:
    struct Binding;
    std::unique_ptr<Binding> earlier_;
    void* display_ = nullptr;
};

}  // namespace weft
