// The table of keys and the table of mouse gestures.
#include "viewer/key_bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace weft::viewer {

namespace {

// GLFW's codes of the keys that print nothing, as numbers: this file knows no window.
namespace key {
constexpr int escape = 256, tab = 258, right = 262, left = 263;
constexpr int f1 = 290, f9 = 298, f12 = 301;
constexpr int keypad_minus = 333, keypad_plus = 334;
}  // namespace key

constexpr bool ctrl = true, shifted = true;

// clang-format off
constexpr std::array keys{
    KeyBinding{Action::pause, ' ', false, false, "Space", "pause or go on"},
    KeyBinding{Action::step, key::right, false, false, "Right arrow or N", "one frame, and pause"},
    KeyBinding{Action::step, 'N', false, false, "", ""},
    KeyBinding{Action::step_back, key::left, false, false, "Left arrow", "one frame back (recordings only)"},
    KeyBinding{Action::reset, 'R', false, false, "R", "start again"},
    KeyBinding{Action::faster, '=', false, false, "+ or =", "faster"},
    KeyBinding{Action::faster, key::keypad_plus, false, false, "", ""},
    KeyBinding{Action::slower, '-', false, false, "-", "slower"},
    KeyBinding{Action::slower, key::keypad_minus, false, false, "", ""},
    KeyBinding{Action::choose_method, '1', false, false, "1 to 9",
        "method: forward-euler, verlet, velocity-verlet, symplectic-euler, rk4, implicit-euler, tr-bdf2, xpbd, auto"},
    KeyBinding{Action::choose_method, '2', false, false, "", ""},
    KeyBinding{Action::choose_method, '3', false, false, "", ""},
    KeyBinding{Action::choose_method, '4', false, false, "", ""},
    KeyBinding{Action::choose_method, '5', false, false, "", ""},
    KeyBinding{Action::choose_method, '6', false, false, "", ""},
    KeyBinding{Action::choose_method, '7', false, false, "", ""},
    KeyBinding{Action::choose_method, '8', false, false, "", ""},
    KeyBinding{Action::choose_method, '9', false, false, "", ""},
    KeyBinding{Action::compare, 'K', false, false, "K", "compare with other methods, side by side"},
    KeyBinding{Action::frame_cloth, 'C', false, false, "C", "show the whole cloth"},
    KeyBinding{Action::wireframe, 'W', false, false, "W", "wireframe"},
    KeyBinding{Action::springs, 'S', false, false, "S", "springs: by strain, by kind, none"},
    KeyBinding{Action::particles, 'V', false, false, "V", "particles"},
    KeyBinding{Action::normals, 'M', false, false, "M", "normals"},
    KeyBinding{Action::wind_arrows, 'A', false, false, "A", "wind arrows"},
    KeyBinding{Action::panels, key::tab, false, false, "Tab", "hide or show the panels"},
    KeyBinding{Action::add_sphere, 'O', false, false, "O", "drop a sphere"},
    KeyBinding{Action::add_plane, 'P', false, false, "P", "lay a plane"},
    KeyBinding{Action::undo, 'Z', ctrl, false, "Ctrl+Z", "undo a change"},
    KeyBinding{Action::redo, 'Y', ctrl, false, "Ctrl+Y or Ctrl+Shift+Z", "redo it"},
    KeyBinding{Action::redo, 'Z', ctrl, shifted, "", ""},
    KeyBinding{Action::open, 'O', ctrl, false, "Ctrl+O", "open a scene or a recording"},
    KeyBinding{Action::save, 'S', ctrl, false, "Ctrl+S", "save the scene"},
    KeyBinding{Action::record, 'R', ctrl, false, "Ctrl+R or F9", "start or stop a recording"},
    KeyBinding{Action::record, key::f9, false, false, "", ""},
    KeyBinding{Action::screenshot, key::f12, false, false, "F12", "screenshot"},
    KeyBinding{Action::help, key::f1, false, false, "F1 or ?", "this help"},
    KeyBinding{Action::help, '/', false, shifted, "", ""},
    KeyBinding{Action::escape, key::escape, false, false, "Esc", "close what is open, let go; never loses work"},
    KeyBinding{Action::quit, 'Q', ctrl, false, "Ctrl+Q", "quit"},
};

constexpr std::array gestures{
    MouseBinding{"left drag on the cloth", "grabs it"},
    MouseBinding{"left drag on a pin", "moves it"},
    MouseBinding{"left drag on a sphere, or a plane's arrow", "moves it"},
    MouseBinding{"left drag elsewhere", "turns the view"},
    MouseBinding{"right or middle drag", "shifts the view"},
    MouseBinding{"wheel", "nearer or farther"},
    MouseBinding{"click on the cloth", "pins it there"},
    MouseBinding{"click on a pin", "takes it out"},
    MouseBinding{"Ctrl+click on a slider", "takes a number from the keyboard"},
    MouseBinding{"right click on a slider", "back to the value of the scene file"},
    MouseBinding{"a file dropped on the window", "opens it"},
};
// clang-format on

constexpr std::array<std::string_view, 9> methods{"forward-euler",    "verlet", "velocity-verlet",
                                                  "symplectic-euler", "rk4",    "implicit-euler",
                                                  "tr-bdf2",          "xpbd",   "auto"};

}  // namespace

std::span<const KeyBinding> key_bindings() {
    return keys;
}

std::span<const MouseBinding> mouse_bindings() {
    return gestures;
}

std::span<const std::string_view> numbered_methods() {
    return methods;
}

std::optional<BoundAction> action_of(int key, bool control, bool shift) {
    const auto find = [&](bool with_shift) {
        return std::find_if(keys.begin(), keys.end(), [&](const KeyBinding& row) {
            return row.key == key && row.control == control && row.shift == with_shift;
        });
    };
    auto row = find(shift);
    if (row == keys.end()) row = find(false);  // a row without Shift holds either way
    if (row == keys.end()) return std::nullopt;
    return BoundAction{row->action, row->action == Action::choose_method ? key - '0' : 0};
}

std::string key_bindings_markdown() {
    std::string text = "| key | does |\n|---|---|\n";
    for (const KeyBinding& row : keys) {
        if (!row.keys.empty()) text += fmt::format("| {} | {} |\n", row.keys, row.meaning);
    }
    text += "\n| mouse | does |\n|---|---|\n";
    for (const MouseBinding& row : gestures) {
        text += fmt::format("| {} | {} |\n", row.gesture, row.meaning);
    }
    return text;
}

}  // namespace weft::viewer
