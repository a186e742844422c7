// What the window remembers from one time to the next.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace weft::viewer {

struct WindowSettings {
    std::array<int, 2> size{1280, 720};   ///< [screen co-ordinates]
    std::array<int, 2> position{-1, -1};  ///< negative: the system chooses
    bool maximised = false;
    bool panels = true;
    bool wireframe = false, particles = false, normals = false, wind_arrows = false, pins = true;
    int springs = 0;  ///< 0 none, 1 by strain, 2 by kind
    std::string recording_format = "mp4";
    std::vector<std::string> recent;  ///< scenes and recordings, the latest first, 10 at most
};

/// $XDG_CONFIG_HOME/weft/window.json, or ~/.config/weft/window.json; empty: neither is known.
std::filesystem::path window_settings_path();
/// Defaults where the file is missing; values that are damaged or out of range are replaced by
/// their defaults one by one.
WindowSettings load_window_settings(const std::filesystem::path& path);
/// Quietly does nothing where it cannot write: a window must close all the same.
void save_window_settings(const WindowSettings& settings, const std::filesystem::path& path);
void remember(WindowSettings& settings, const std::string& opened);

}  // namespace weft::viewer
