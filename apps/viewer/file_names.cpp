#include "viewer/file_names.h"

#include <fmt/format.h>

#include "weft/error.h"
#include "weft/scene.h"

namespace weft::viewer {

namespace fs = std::filesystem;

fs::path numbered_file(const fs::path& directory, std::string_view stem, std::string_view ending) {
    for (int n = 1;; ++n) {
        fs::path file = directory / fmt::format("{}-{:04d}.{}", stem, n, ending);
        if (!fs::exists(file)) return file;
    }
}

std::string suggested_scene_file(std::string_view stem) {
    constexpr std::string_view suffix = "-edited";
    const bool edited_before =
        stem.size() > suffix.size() && stem.substr(stem.size() - suffix.size()) == suffix;
    return fmt::format("./{}{}.toml", stem, edited_before ? "" : suffix);
}

std::string objection_to_scene_file(const std::string& path) {
    const fs::path file = path;
    std::error_code unreadable;
    if (path.empty() || file.filename().empty()) return "Type the name of a file.";
    if (file.extension() != ".toml") return "The name must end in .toml.";
    const fs::path directory = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::is_directory(directory, unreadable)) {
        return fmt::format("There is no directory {}.", directory.string());
    }
    if (fs::is_directory(file, unreadable)) return "That is a directory.";
    return {};
}

bool is_shipped_scene_file(const fs::path& path) {
    std::error_code missing;
    try {
        for (const ShippedScene& scene : shipped_scenes()) {
            if (fs::equivalent(scene.path, path, missing)) return true;
        }
    } catch (const Error&) {
        return false;  // no data directory, so no shipped scene either
    }
    return false;
}

}  // namespace weft::viewer
