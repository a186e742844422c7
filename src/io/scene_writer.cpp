// Saving a scene: the scene file, and what it refers to.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "cloth/same_mesh.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "io/scene_limits.h"
#include "io/scene_toml.h"
#include "io/start_state_file.h"
#include "math/quoting.h"
#include "render/image.h"
#include "weft/error.h"
#include "weft/scene.h"

namespace weft {

namespace {

namespace fs = std::filesystem;

/// How far up a relative path may begin: farther, the two files hardly move together.
constexpr std::ptrdiff_t most_steps_up = 2;

/// `path` as it may stand in a scene file of `directory`.
std::string path_from(const fs::path& directory, const std::string& path) {
    const fs::path target = fs::absolute(path).lexically_normal();
    const fs::path relative = target.lexically_relative(directory);
    const auto up = std::count(relative.begin(), relative.end(), "..");
    const fs::path below_root = directory.relative_path();
    const bool over_root = up > 0 && up == std::distance(below_root.begin(), below_root.end());
    if (relative.empty() || up > most_steps_up || over_root) return target.string();
    // From a directory that is a link, ".." leads the reader where it leads no other program.
    std::error_code ignored;
    if (up > 0 && fs::weakly_canonical(directory, ignored) != directory) return target.string();
    return relative.string();
}

bool is_texture_name(const std::string& texture) {
    const auto& names = texture_catalogue();
    return std::any_of(names.begin(), names.end(),
                       [&](const TextureInfo& row) { return row.name == texture; });
}

/// The scene refers to the file, so what it has must be what the file has.
void require_mesh_file(const ClothDescription& cloth) {
    if (cloth.mesh_path.empty()) {
        throw scene_error("cloth.mesh", in_quotes(cloth.mesh_path),
                          "the path of the mesh's file, to save the scene");
    }
    if (same_mesh(load_mesh(cloth.mesh_path), *cloth.mesh)) return;
    throw file_error(cloth.mesh_path, "is no longer the mesh of the scene that is saved");
}

std::string start_name(const fs::path& file) {
    return file.stem().string() + ".start.npy";
}

/// The scene with its paths as they stand in `file`.
SceneDescription with_paths_from(const fs::path& file, SceneDescription scene) {
    const fs::path directory = fs::absolute(file).lexically_normal().parent_path();
    if (scene.cloth.mesh) scene.cloth.mesh_path = path_from(directory, scene.cloth.mesh_path);
    if (scene.start.state) scene.start.state_path = start_name(file);
    std::string& texture = scene.render.texture;
    if (is_texture_name(texture)) return scene;
    texture = path_from(directory, texture);
    if (is_texture_name(texture)) texture = "./" + texture;  // a file called "flag"
    return scene;
}

}  // namespace

std::vector<fs::path> save_scene(const SceneDescription& scene, const fs::path& file) {
    check_scene(scene);
    if (scene.cloth.mesh) require_mesh_file(scene.cloth);
    const std::string text = scene_to_toml(with_paths_from(file, scene));
    if (text.size() > largest_scene_file) {
        throw file_error(file.string(), fmt::format("cannot be written: the scene takes {} bytes, "
                                                    "and at most {} can be read",
                                                    text.size(), largest_scene_file));
    }
    OutputFile scene_file(file);
    scene_file.write(text);
    scene_file.close();
    std::optional<OutputFile> state_file;
    if (scene.start.state) {
        state_file.emplace(file.parent_path() / start_name(file));
        write_start_state(*state_file, *scene.start.state);
        state_file->commit();
    }
    scene_file.commit();
    std::vector<fs::path> files{file};
    if (state_file) files.push_back(state_file->path());
    return files;
}

}  // namespace weft
