// An OpenGL context by EGL on the surfaceless platform of Mesa.
#include "render/gl_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <string>

#include "weft/error.h"

namespace weft {

namespace {

[[noreturn]] void throw_without_gl(const std::string& reason) {
    throw Error(ErrorKind::file, {}, "pictures need OpenGL 3.3 through EGL: " + reason,
                "Install a driver (apt install libegl1 libgl1-mesa-dri), or choose formats without "
                "pictures: glb, pc2, mdd, npy, obj, ply.");
}

[[noreturn]] void throw_unavailable(const std::string& step) {
    throw_without_gl(fmt::format("{} failed (EGL error {:#x})", step, eglGetError()));
}

/// epoxy ends the process where it does not find this library, so it is looked for beforehand. It
/// stays loaded.
void require_egl_library() {
    if (dlopen("libEGL.so.1", RTLD_LAZY) == nullptr)
        throw_without_gl("libEGL.so.1 is not installed");
}

EGLDisplay open_display() {
    require_egl_library();
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base"))
        throw_unavailable("finding EGL_EXT_platform_base");
    const EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) throw_unavailable("opening the surfaceless display");
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        throw_unavailable("initialising the display");
    return display;
}

/// The display of the surfaceless platform. Every context of the process shares it, for EGL hands
/// out the same one each time; it stays open, since closing it would end them all.
EGLDisplay shared_display() {
    static const EGLDisplay display = open_display();
    return display;
}

EGLContext create_context(EGLDisplay display) {
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) throw_unavailable("choosing OpenGL");
    constexpr EGLint config_attributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                            EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, config_attributes, &config, 1, &count) == EGL_FALSE || count < 1)
        throw_unavailable("choosing a configuration");
    constexpr EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                             3,
                                             EGL_CONTEXT_MINOR_VERSION,
                                             3,
                                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                             EGL_NONE};
    const EGLContext context =
        eglCreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
    if (context == EGL_NO_CONTEXT) throw_unavailable("creating a context");
    return context;
}

}  // namespace

struct GlContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
};

GlContext::GlContext() : state_(std::make_unique<State>()) {
    state_->display = shared_display();
    state_->context = create_context(state_->display);
}

GlContext::~GlContext() {
    eglDestroyContext(state_->display, state_->context);
}

struct CurrentContext::Binding {
    EGLDisplay display = eglGetCurrentDisplay();
    EGLContext context = eglGetCurrentContext();
    EGLSurface draw = eglGetCurrentSurface(EGL_DRAW);
    EGLSurface read = eglGetCurrentSurface(EGL_READ);
};

CurrentContext::CurrentContext(const GlContext& context)
    : earlier_(std::make_unique<Binding>()), display_(context.state_->display) {
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.state_->context) ==
        EGL_FALSE) {
        throw_unavailable("making the context current");
    }
}

CurrentContext::~CurrentContext() {
    if (earlier_->context != EGL_NO_CONTEXT) {
        eglMakeCurrent(earlier_->display, earlier_->draw, earlier_->read, earlier_->context);
    } else {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
}

}  // namespace weft
