#include "io/data_directory.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "weft/error.h"

namespace weft {

namespace {

bool holds_scenes(const std::filesystem::path& directory) {
    std::error_code ignored;
    return std::filesystem::is_directory(directory / "scenes", ignored);
}

}  // namespace

std::filesystem::path data_directory() {
    namespace fs = std::filesystem;
    if (const char* chosen = std::getenv("WEFT_DATA_DIR"); chosen && *chosen) {
        if (holds_scenes(chosen)) return chosen;
        throw file_error(
            chosen, "holds no directory \"scenes\"",
            "The environment variable WEFT_DATA_DIR names it as weft's data directory.");
    }
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    std::vector<fs::path> places;
    if (!error) places.push_back((program.parent_path() / "../share/weft").lexically_normal());
    places.emplace_back(WEFT_SOURCE_DATA_DIR);
    places.emplace_back(WEFT_INSTALL_DATA_DIR);
    std::string looked_at = "Looked for a directory \"scenes\" in";
    for (const fs::path& place : places) {
        if (holds_scenes(place)) return place;
        looked_at += fmt::format("\n    {}", place.string());
    }
    throw file_error("scenes", "weft's data directory cannot be found; set WEFT_DATA_DIR to it",
                     looked_at);
}

}  // namespace weft
