// The dialog that opens scenes and recordings.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viewer/window_settings.h"
#include "weft/scene.h"

namespace weft::viewer {

class OpenDialog {
public:
    void open();
    [[nodiscard]] bool is_open() const { return is_open_; }
    void close() { is_open_ = false; }
    /// What could not be opened, and why: it stays open.
    void complain(const std::string& why) { complaint_ = why; }

    /// @return what was chosen: a path, or the name of a shipped scene.
    std::optional<std::string> draw(const WindowSettings& settings);

private:
    void list_directory();
    void draw_shipped(std::optional<std::string>& chosen);
    void draw_recent(const WindowSettings& settings, std::optional<std::string>& chosen);
    void draw_files(std::optional<std::string>& chosen);

    bool is_open_ = false;
    std::vector<ShippedScene> shipped_;
    std::filesystem::path directory_;
    std::vector<std::string> entries_;  ///< directories end in "/"
    std::string path_, complaint_;
};

/// Scenes, recordings and directories of a directory, by name, directories first and ending in "/".
std::vector<std::string> openable_entries(const std::filesystem::path& directory);

}  // namespace weft::viewer
