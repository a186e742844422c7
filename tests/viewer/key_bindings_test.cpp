// The table of keys: every action is in it, none twice, and the guide shows it.
#include "viewer/key_bindings.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <tuple>

#include "weft/integrators.h"

namespace weft::viewer {
namespace {

TEST(KeyBindings, StandOnceAKey) {
    std::set<std::tuple<int, bool, bool>> seen;
    for (const KeyBinding& row : key_bindings()) {
        EXPECT_TRUE(seen.insert({row.key, row.control, row.shift}).second) << row.key;
    }
}

TEST(KeyBindings, HoldEveryAction) {
    std::set<Action> bound;
    for (const KeyBinding& row : key_bindings()) bound.insert(row.action);
    for (int action = 0; action <= static_cast<int>(Action::quit); ++action) {
        EXPECT_EQ(bound.count(static_cast<Action>(action)), 1U) << action;
    }
}

TEST(KeyBindings, OtherKeysOfAnActionFollowTheRowThatNamesIt) {
    Action named = Action::quit;
    std::set<Action> seen;
    for (const KeyBinding& row : key_bindings()) {
        EXPECT_EQ(row.keys.empty(), row.meaning.empty()) << row.key;
        if (row.keys.empty()) {
            EXPECT_EQ(row.action, named) << row.key;
        } else {
            EXPECT_TRUE(seen.insert(row.action).second) << row.keys;
            named = row.action;
        }
    }
}

TEST(KeyBindings, AreFoundByTheirOwnKeys) {
    for (const KeyBinding& row : key_bindings()) {
        const auto found = action_of(row.key, row.control, row.shift);
        ASSERT_TRUE(found) << row.key;
        EXPECT_EQ(found->action, row.action) << row.key;
    }
}

TEST(KeyBindings, AskForShiftOnlyWhereTheyNameIt) {
    EXPECT_EQ(action_of('W', false, true)->action, Action::wireframe);
    EXPECT_EQ(action_of('=', false, true)->action, Action::faster);
    EXPECT_EQ(action_of('Z', true, false)->action, Action::undo);
    EXPECT_EQ(action_of('Z', true, true)->action, Action::redo);
    EXPECT_EQ(action_of('/', false, true)->action, Action::help);
    EXPECT_FALSE(action_of('/', false, false));
}

TEST(KeyBindings, TellControlApart) {
    EXPECT_EQ(action_of('S', false, false)->action, Action::springs);
    EXPECT_EQ(action_of('S', true, false)->action, Action::save);
    EXPECT_EQ(action_of('R', false, false)->action, Action::reset);
    EXPECT_EQ(action_of('R', true, false)->action, Action::record);
    EXPECT_FALSE(action_of('Q', false, false));  // only Ctrl+Q quits
    EXPECT_FALSE(action_of('Z', false, false));
    EXPECT_FALSE(action_of('W', true, false));
}

TEST(KeyBindings, GoByTheCodesOfGlfw) {
    const auto bound = [](int key, bool control = false, bool shift = false) {
        const auto found = action_of(key, control, shift);
        return found ? found->action : Action::quit;
    };
    EXPECT_EQ(bound(GLFW_KEY_SPACE), Action::pause);
    EXPECT_EQ(bound(GLFW_KEY_RIGHT), Action::step);
    EXPECT_EQ(bound(GLFW_KEY_N), Action::step);
    EXPECT_EQ(bound(GLFW_KEY_LEFT), Action::step_back);
    EXPECT_EQ(bound(GLFW_KEY_EQUAL), Action::faster);
    EXPECT_EQ(bound(GLFW_KEY_KP_ADD), Action::faster);
    EXPECT_EQ(bound(GLFW_KEY_MINUS), Action::slower);
    EXPECT_EQ(bound(GLFW_KEY_KP_SUBTRACT), Action::slower);
    EXPECT_EQ(bound(GLFW_KEY_TAB), Action::panels);
    EXPECT_EQ(bound(GLFW_KEY_ESCAPE), Action::escape);
    EXPECT_EQ(bound(GLFW_KEY_F1), Action::help);
    EXPECT_EQ(bound(GLFW_KEY_SLASH, false, true), Action::help);
    EXPECT_EQ(bound(GLFW_KEY_F9), Action::record);
    EXPECT_EQ(bound(GLFW_KEY_F12), Action::screenshot);
    EXPECT_EQ(bound(GLFW_KEY_Z, true), Action::undo);
    EXPECT_EQ(bound(GLFW_KEY_Z, true, true), Action::redo);
    EXPECT_EQ(action_of(GLFW_KEY_7, false, false)->number, 7);
}

TEST(KeyBindings, NumbersChooseMethodsThatExist) {
    ASSERT_EQ(numbered_methods().size(), 9U);
    for (int number = 1; number <= 9; ++number) {
        const auto found = action_of('0' + number, false, false);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->action, Action::choose_method);
        EXPECT_EQ(found->number, number);
        const std::string_view method = numbered_methods()[static_cast<std::size_t>(number - 1)];
        EXPECT_TRUE(method == "auto" || find_integrator(method) != nullptr) << method;
    }
    EXPECT_FALSE(action_of('0', false, false));
    EXPECT_EQ(action_of(' ', false, false)->number, 0);
}

TEST(KeyBindings, NameTheMethodsInOrder) {
    const auto expected = fmt::format("method: {}", fmt::join(numbered_methods(), ", "));
    bool found = false;
    for (const KeyBinding& row : key_bindings()) {
        if (row.action != Action::choose_method || row.keys.empty()) continue;
        EXPECT_EQ(row.meaning, expected);
        found = true;
    }
    EXPECT_TRUE(found);
}

TEST(WindowDocument, HoldsTheTablesOfKeys) {
    std::ifstream file(WEFT_SOURCE_DIR "/docs/window.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string begin = "<!-- keys: begin -->\n", end = "<!-- keys: end -->\n";
    const std::size_t from = text.find(begin), to = text.find(end);
    ASSERT_NE(from, std::string::npos);
    ASSERT_NE(to, std::string::npos);
    const std::size_t start = from + begin.size();
    EXPECT_EQ(text.substr(start, to - start), key_bindings_markdown())
        << "docs/window.md is out of date: put the tables on the right between the two lines with "
           "\"keys:\".";
}

}  // namespace
}  // namespace weft::viewer
