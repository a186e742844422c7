// The scenes that come with weft: the files in scenes/ of its data directory.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "io/data_directory.h"
#include "io/scene_limits.h"
#include "io/text_file.h"
#include "io/toml_value.h"
#include "weft/scene.h"

namespace weft {

std::vector<ShippedScene> shipped_scenes() {
    std::vector<ShippedScene> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(data_directory() / "scenes")) {
        const std::filesystem::path& path = entry.path();
        if (path.extension() != ".toml" || !entry.is_regular_file()) continue;
        const std::string text = read_text_file(path.string(), largest_scene_file);
        const TomlValue document = parse_toml(text, path.string());
        const TomlValue* title = document.find("name");
        const std::string stem = path.stem().string();
        scenes.push_back({stem, path, title && title->string() ? *title->string() : stem});
    }
    std::sort(scenes.begin(), scenes.end(),
              [](const ShippedScene& a, const ShippedScene& b) { return a.name < b.name; });
    return scenes;
}

}  // namespace weft
