// Names of files that the window writes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace weft::viewer {

/// The first of STEM-0001.ENDING, STEM-0002.ENDING, ... in a directory that does not exist.
std::filesystem::path numbered_file(const std::filesystem::path& directory, std::string_view stem,
                                    std::string_view ending);

/// Where an edited scene is saved unless something else is asked for: beside nothing of the
/// user's, in the present directory, as STEM-edited.toml.
std::string suggested_scene_file(std::string_view stem);

/// Why a scene cannot be saved under this name, in a sentence; empty: it can.
std::string objection_to_scene_file(const std::string& path);

/// Whether a path lies in the directory of the shipped scenes.
bool is_shipped_scene_file(const std::filesystem::path& path);

}  // namespace weft::viewer
