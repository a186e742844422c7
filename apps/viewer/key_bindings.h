// What keys and mouse do, as one table: the window obeys it, the help overlay and the guide show
// it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace weft::viewer {

enum class Action {
    pause,
    step,
    step_back,
    reset,
    frame_cloth,
    wireframe,
    faster,
    slower,
    choose_method,  ///< by the number of the key, 1 to 9
    help,
    screenshot,
    escape,
    undo,
    redo,
    save,
    open,
    record,
    add_sphere,
    add_plane,
    compare,
    panels,
    springs,
    particles,
    normals,
    wind_arrows,
    quit
};

struct KeyBinding {
    Action action;
    int key;                   ///< GLFW's code, which for printable keys is ASCII's capital
    bool control = false;      ///< Ctrl held
    bool shift = false;        ///< Shift held; without: either way
    std::string_view keys;     ///< "Space"; empty: another key of the row before
    std::string_view meaning;  ///< "pause or go on"
};
std::span<const KeyBinding> key_bindings();

/// A row of the help overlay that no key stands for.
struct MouseBinding {
    std::string_view gesture, meaning;  ///< "left drag on the cloth", "grabs it"
};
std::span<const MouseBinding> mouse_bindings();

struct BoundAction {
    Action action;
    int number = 0;  ///< of choose_method
};
std::optional<BoundAction> action_of(int key, bool control, bool shift);

/// Names of the methods that 1 to 9 choose.
std::span<const std::string_view> numbered_methods();

/// Both tables as Markdown, for docs/window.md.
std::string key_bindings_markdown();

}  // namespace weft::viewer
