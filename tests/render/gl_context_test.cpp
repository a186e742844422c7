// OpenGL contexts without a window.
#include "render/gl_context.h"

#include <epoxy/egl.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "weft/error.h"

namespace weft {
namespace {

TEST(GlContext, IsCurrentOnlyWhereItIsAskedFor) {
    const GlContext first, second;
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
    {
        const CurrentContext outer(first);
        const EGLContext name = eglGetCurrentContext();
        EXPECT_NE(name, EGL_NO_CONTEXT);
        {
            const CurrentContext inner(second);
            EXPECT_NE(eglGetCurrentContext(), name);
        }
        EXPECT_EQ(eglGetCurrentContext(), name);
    }
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

TEST(GlContext, OutlivesAnEarlierOne) {
    { const GlContext earlier; }
    const GlContext context;
    const CurrentContext current(context);
    EXPECT_NE(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

/// Ends the process with 3 where a context is refused by a file error, whose words it prints.
[[noreturn]] void make_context_without_driver() {
    // EGL looks for drivers where this variable says: nowhere.
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere/driver.json", 1);
    try {
        const GlContext context;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n%s\n", error.what(), error.detail().c_str());
        std::exit(error.kind() == ErrorKind::file ? 3 : 1);
    }
    std::exit(0);
}

TEST(GlContextDeathTest, MissingDriverIsAFileErrorThatSaysWhatToDo) {
    // A new process each, since EGL reads the variable once.
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(make_context_without_driver(), testing::ExitedWithCode(3),
                "pictures need OpenGL 3.3 through EGL: [^\n]+\n.*apt install libegl1");
}

}  // namespace
}  // namespace weft
