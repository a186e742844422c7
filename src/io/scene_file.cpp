// Reading scene files: from a name or a text to a SceneDescription that has passed every check.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh_file.h"
#include "io/scene_document.h"
#include "io/scene_limits.h"
#include "io/scene_reader.h"
#include "io/start_state_file.h"
#include "io/text_file.h"
#include "math/nearest_name.h"
#include "math/quoting.h"
#include "render/image.h"
#include "weft/error.h"
#include "weft/recorder.h"
#include "weft/scene.h"

namespace weft {

namespace {

namespace fs = std::filesystem;

template <typename Catalogue>
std::vector<std::string_view> names_of(const Catalogue& catalogue) {
    std::vector<std::string_view> names;
    for (const auto& row : catalogue) names.push_back(row.name);
    return names;
}

template <typename Names>
bool contains(const Names& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The path written at `key`: a relative one is relative to the scene file, or, given on the
/// command line, to the current directory.
fs::path resolved(const std::string& path, const std::string& key, const SceneDocument& document) {
    if (document.locate(key).source != 0) return fs::path(path).lexically_normal();
    return (fs::path(document.file).parent_path() / path).lexically_normal();
}

void require_readable(const fs::path& path, const std::string& key, const std::string& written,
                      const SceneDocument& document) {
    std::error_code ignored;
    std::string reason;
    if (!fs::exists(path, ignored)) {
        reason = "no such file";
    } else if (!fs::is_regular_file(path, ignored)) {
        reason = "not a file";
    } else if (!std::ifstream(path)) {
        reason = "no permission";
    } else {
        return;
    }
    throw Error(ErrorKind::file, document.error_place(document.locate(key), key),
                fmt::format("{} cannot be read: {}", in_quotes(written), reason),
                fmt::format("Looked for {}.", path.string()));
}

/// Path of the file that the scene names at a key; none: it has no such key.
/// @param written as it stands there.  @param allowed says what file, for errors.
std::optional<fs::path> named_file(std::string_view section, std::string_view name,
                                   const std::string& written, const std::string& allowed,
                                   const SceneDocument& document) {
    const TomlValue* table = document.root.find(section);
    if (!table || !table->find(name)) return {};
    const std::string key = fmt::format("{}.{}", section, name);
    if (written.empty()) throw scene_error(key, in_quotes(written), allowed);
    const fs::path path = resolved(written, key, document);
    require_readable(path, key, written, document);
    return path;
}

void load_mesh_of(SceneDescription& scene, const SceneDocument& document) {
    std::string& written = scene.cloth.mesh_path;
    const auto path = named_file("cloth", "mesh", written, "path of an OBJ or PLY file", document);
    if (!path) return;
    written = path->string();
    scene.cloth.mesh = std::make_shared<const Mesh>(load_mesh(*path));
}

void load_start_of(SceneDescription& scene, const SceneDocument& document) {
    std::string& written = scene.start.state_path;
    const auto path = named_file("start", "state", written, "path of a NumPy file", document);
    if (!path) return;
    written = path->string();
    scene.start.state = std::make_shared<const ClothState>(load_start_state(*path));
}

void resolve_texture(SceneDescription& scene, const SceneDocument& document) {
    const std::string key = "render.texture";
    const std::string written = scene.render.texture;
    const std::vector<std::string_view> names = names_of(texture_catalogue());
    if (contains(names, written)) return;
    const fs::path path = resolved(written, key, document);
    std::error_code ignored;
    const bool may_be_name = written.find_first_of("./") == std::string::npos;
    if (may_be_name && !fs::exists(path, ignored)) {
        throw scene_error(key, in_quotes(written),
                          fmt::format("{} or the path of a PNG or JPEG file{}",
                                      fmt::join(names, ", "), did_you_mean(written, names)));
    }
    require_readable(path, key, written, document);
    scene.render.texture = path.string();
}

void check_formats(const std::vector<std::string>& formats) {
    const std::vector<std::string_view> names = names_of(format_catalogue());
    for (std::size_t i = 0; i < formats.size(); ++i) {
        const std::string key = fmt::format("output.formats[{}]", i);
        if (!contains(names, formats[i])) {
            throw scene_error(
                key, in_quotes(formats[i]),
                fmt::format("{}{}", fmt::join(names, ", "), did_you_mean(formats[i], names)));
        }
        const auto before = formats.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::find(formats.begin(), before, formats[i]) != before) {
            throw scene_error(key, in_quotes(formats[i]), "each format once");
        }
    }
}

/// @return the path of the scene that a user asked for by path or by name.
std::string find_scene(const std::string& scene) {
    const bool is_path = scene.find('/') != std::string::npos || scene.ends_with(".toml");
    if (is_path) return scene;
    const std::vector<ShippedScene> shipped = shipped_scenes();
    const auto names = names_of(shipped);
    const auto found = std::find(names.begin(), names.end(), scene);
    if (found != names.end()) {
        return shipped[static_cast<std::size_t>(found - names.begin())].path.string();
    }
    std::error_code ignored;
    if (fs::is_regular_file(scene, ignored)) return scene;
    throw Error(ErrorKind::usage, {},
                fmt::format("no shipped scene is called {}{}; there are {}", in_quotes(scene),
                            did_you_mean(scene, names), fmt::join(names, ", ")),
                "A scene file of your own is given by its path, ending in .toml.");
}

}  // namespace

SceneDescription parse_scene(std::string_view text, const std::string& file,
                             std::span<const SceneOverride> overrides) {
    const SceneDocument document = read_scene_document(text, file, overrides);
    try {
        SceneDescription scene = read_scene(document);
        load_mesh_of(scene, document);
        load_start_of(scene, document);
        check_formats(scene.output.formats);
        resolve_texture(scene, document);
        check_scene(scene);
        return scene;
    } catch (const Error& error) {
        if (!error.place().file.empty()) throw;
        const std::string& key = error.place().key;
        throw Error(error.kind(), document.error_place(document.locate(key), key), error.message(),
                    error.detail());
    }
}

SceneDescription load_scene(const std::string& scene, std::span<const SceneOverride> overrides) {
    const std::string path = find_scene(scene);
    return parse_scene(read_text_file(path, largest_scene_file), path, overrides);
}

}  // namespace weft
