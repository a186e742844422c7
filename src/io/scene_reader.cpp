#include "io/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "io/scene_keys.h"
#include "io/scene_values.h"
#include "math/quoting.h"

namespace weft {

namespace {

std::string joined(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "." + name;
}

/// Walks the tree from the top of the file, and reads what it finds.
class SceneReader {
public:
    SceneReader(const SceneDocument& document, SceneDescription& scene)
        : document_(document), scene_(scene) {}

    /// @param path the key as in the file, "pins[1].select".
    /// @param key the key as in the table, "pins[].select".
    void read(const TomlValue& value, const std::string& path, const std::string& key) {
        const SceneKey* row = find_scene_key(key);
        const bool is_section = !names_in_section(key).empty();
        if (row && !(is_section && value.table())) {
            read_scene_value(*row, path, value, scene_, index_);
        } else if (is_section) {
            read_section(value, path, key);
        } else {
            read_list(value, path, *list_of_scene_key(key + "[]"));
        }
    }

    void read_section(const TomlValue& value, const std::string& path, const std::string& key) {
        if (!value.table()) {
            throw scene_error(
                path, toml_text(value),
                fmt::format("a table with the keys {}", fmt::join(names_in_section(key), ", ")));
        }
        make_room_for(key);
        for (const TomlValue::Member& member : *value.table()) {
            const std::string name = joined(key, member.key);
            if (!is_known(name)) refuse_unknown(member, path, key);
            read(member.value, joined(path, member.key), name);
        }
    }

private:
    static bool is_known(const std::string& key) {
        return find_scene_key(key) || !names_in_section(key).empty() ||
               !names_in_section(key + "[]").empty();
    }

    void read_list(const TomlValue& value, const std::string& path, const SceneList& list) {
        const auto* array = value.array();
        if (!array) {
            throw scene_error(path, toml_text(value),
                              fmt::format("a list of tables, [[{}]]", list.name));
        }
        list.renew(scene_, array->size());
        for (index_ = 0; index_ < array->size(); ++index_) {
            const TomlValue& element = (*array)[index_];
            const std::string element_path = fmt::format("{}[{}]", path, index_);
            read_section(element, element_path, fmt::format("{}[]", list.name));
            if (list.name == "pins") require_selection(element, element_path);
            if (list.name == "obstacles") require_one_shape(element, element_path);
        }
    }

    static void require_selection(const TomlValue& pin, const std::string& path) {
        if (pin.find("select")) return;
        throw Error(
            ErrorKind::usage, {.file = {}, .key = path + ".select"},
            fmt::format("not given; allowed is {}", find_scene_key("pins[].select")->allowed));
    }

    static void require_one_shape(const TomlValue& obstacle, const std::string& path) {
        const TomlValue* plane = obstacle.find("plane");
        if (plane && obstacle.find("sphere")) {
            throw scene_error(path + ".plane", toml_text(*plane), "sphere or plane, not both");
        }
        if (plane || obstacle.find("sphere")) return;
        throw Error(ErrorKind::usage, {.file = {}, .key = path},
                    "has no shape; allowed is sphere = { centre = [x, y, z], radius = NUMBER } or "
                    "plane = { point = [x, y, z], normal = [x, y, z] }");
    }

    /// What a table brings with its defaults by being there.
    void make_room_for(const std::string& section) {
        if (section == "wind" && !scene_.wind) scene_.wind = WindDescription{};
        if (section == "obstacles[].sphere") scene_.obstacles[index_].shape = SphereObstacle{};
        if (section == "obstacles[].plane") scene_.obstacles[index_].shape = PlaneObstacle{};
    }

    [[noreturn]] void refuse_unknown(const TomlValue::Member& member,
                                     const std::string& parent_path, const std::string& section) {
        std::string nearest = nearest_scene_key(section, member.key);
        // Within its own section a key keeps its index: pins[1].select, not pins[].select.
        if (!section.empty() && nearest.starts_with(section + ".")) {
            nearest = parent_path + nearest.substr(section.size());
        }
        const std::string path = one_line(joined(parent_path, member.key));
        const std::string guess =
            nearest.empty() ? "." : fmt::format("; did you mean {}?", nearest);
        const std::string message =
            fmt::format("unknown key (value {}){} Known here: {}", toml_text(member.value), guess,
                        fmt::join(names_in_section(section), ", "));
        throw Error(ErrorKind::usage, document_.error_place(member.key_place, path), message);
    }

    const SceneDocument& document_;
    SceneDescription& scene_;
    std::size_t index_ = 0;  ///< of the pin or obstacle
};

/// What is not said where [cloth] is given: a cloth of one's own starts without the flag's wind,
/// pins, fabric and mast.
SceneDescription defaults_of(const SceneDocument& document) {
    SceneDescription scene;
    scene.file = document.file;
    const std::string stem = std::filesystem::path(document.file).stem().string();
    if (!stem.empty()) scene.stem = stem;
    if (!document.has_cloth) return scene;
    if (stem.empty()) scene.stem = "scene";
    scene.name = scene.stem;
    scene.material.fabric = "cotton";
    scene.pins.clear();
    scene.wind.reset();
    scene.render.texture = "linen";
    scene.render.mast = false;
    return scene;
}

/// Puts the fabric's values in place, before single keys are read over them.
void apply_fabric(const TomlValue* material, MaterialDescription& out) {
    if (const TomlValue* fabric = material ? material->find("fabric") : nullptr) {
        if (fabric->string()) out.fabric = *fabric->string();
    }
    for (const FabricInfo& fabric : fabric_catalogue()) {
        if (fabric.name != out.fabric) continue;
        out.mass_per_area = fabric.mass_per_area;
        out.structural = fabric.structural;
        out.shear = fabric.shear;
        out.bend = fabric.bend;
    }
    const TomlValue* per = material ? material->find("stiffness_per") : nullptr;
    if (!per || !per->string() || *per->string() != "spring") return;
    // A fabric counts per width; of single springs it knows nothing.
    out.structural = out.shear = out.bend = {};
    const TomlValue* structural = material->find("structural");
    if (structural && (!structural->table() || structural->find("stiffness"))) return;
    throw Error(ErrorKind::usage, {.file = {}, .key = "material.structural.stiffness"},
                "not given, but needed with stiffness_per = \"spring\", as fabrics are per width");
}

void check_exclusive(const TomlValue& root) {
    const TomlValue* material = root.find("material");
    const TomlValue* mass = material ? material->find("particle_mass") : nullptr;
    if (mass && material->find("mass_per_area")) {
        throw scene_error("material.particle_mass", toml_text(*mass),
                          "particle_mass or mass_per_area, not both");
    }
    const TomlValue* cloth = root.find("cloth");
    if (!cloth || !cloth->find("mesh")) return;
    for (const std::string name : {"size", "resolution", "plane", "origin"}) {
        const TomlValue* value = cloth->find(name);
        if (!value) continue;
        throw scene_error(
            "cloth." + name, toml_text(*value),
            fmt::format("mesh or {}, not both; a mesh has its own size and place", name));
    }
}

}  // namespace

SceneDescription read_scene(const SceneDocument& document) {
    SceneDescription scene = defaults_of(document);
    apply_fabric(document.root.find("material"), scene.material);
    SceneReader(document, scene).read_section(document.root, "", "");
    check_exclusive(document.root);
    return scene;
}

}  // namespace weft
