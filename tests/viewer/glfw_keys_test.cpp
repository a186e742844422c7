// The table of keys holds GLFW's codes as numbers, as it knows no window; here they are compared.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "viewer/key_bindings.h"

namespace weft::viewer {
namespace {

TEST(GlfwKeys, AreThoseOfTheTable) {
    const auto expect = [](int key, bool control, bool shift, Action action) {
        const auto bound = action_of(key, control, shift);
        ASSERT_TRUE(bound.has_value()) << key;
        EXPECT_EQ(bound->action, action) << key;
    };
    expect(GLFW_KEY_SPACE, false, false, Action::pause);
    expect(GLFW_KEY_RIGHT, false, false, Action::step);
    expect(GLFW_KEY_LEFT, false, false, Action::step_back);
    expect(GLFW_KEY_EQUAL, false, true, Action::faster);
    expect(GLFW_KEY_KP_ADD, false, false, Action::faster);
    expect(GLFW_KEY_MINUS, false, false, Action::slower);
    expect(GLFW_KEY_KP_SUBTRACT, false, false, Action::slower);
    expect(GLFW_KEY_TAB, false, false, Action::panels);
    expect(GLFW_KEY_ESCAPE, false, false, Action::escape);
    expect(GLFW_KEY_F1, false, false, Action::help);
    expect(GLFW_KEY_SLASH, false, true, Action::help);
    expect(GLFW_KEY_F9, false, false, Action::record);
    expect(GLFW_KEY_F12, false, false, Action::screenshot);
    expect(GLFW_KEY_Z, true, true, Action::redo);
    expect(GLFW_KEY_R, false, false, Action::reset);
}

}  // namespace
}  // namespace weft::viewer
