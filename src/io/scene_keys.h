// The keys of a scene file, once: the reader, the messages about misspelt keys, the JSON writer and
// docs/scene-format.md all go by this table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "weft/scene.h"

namespace weft {

/// Where a key's value stands in a scene. `index` is that of the pin or obstacle, and is not read
/// for keys that stand in no list. Keys of the wind may be asked for only where the scene has wind,
/// those of a sphere or plane only of an obstacle that is one.
template <typename Value>
using SceneAccess = Value& (*)(SceneDescription& scene, std::size_t index);

/// Access by type of value; monostate: the key "version", which a description does not hold.
using SceneField =
    std::variant<std::monostate, SceneAccess<bool>, SceneAccess<double>, SceneAccess<std::uint64_t>,
                 SceneAccess<std::string>, SceneAccess<Vec3d>, SceneAccess<std::array<double, 2>>,
                 SceneAccess<std::array<int, 2>>, SceneAccess<std::optional<double>>,
                 SceneAccess<std::optional<int>>, SceneAccess<LinearSolver>,
                 SceneAccess<std::optional<Vec3d>>, SceneAccess<std::vector<std::string>>,
                 SceneAccess<Plane>, SceneAccess<StiffnessPer>, SceneAccess<BendLayout>,
                 SceneAccess<Precision>, SceneAccess<OnDivergence>, SceneAccess<GustModel>,
                 SceneAccess<PinSelector>, SceneAccess<std::vector<PinKeyframe>>>;

struct SceneKey {
    std::string_view key;       ///< dotted; a key of each pin is "pins[].select"
    std::string_view unit;      ///< "m/s"; empty: none
    std::string_view fallback;  ///< value of `version = 1` alone, in TOML; empty: none
    std::string_view allowed;   ///< in words, also said by errors
    std::string_view meaning;   ///< a sentence or two
    SceneField field;
    /// Whether the value counts in this scene, and for this pin or obstacle: the size of a grid
    /// does not where there is a mesh. Null: always.
    bool (*applies)(const SceneDescription& scene, std::size_t index) = nullptr;
};

/// A list of tables: [[pins]].
struct SceneList {
    std::string_view name;  ///< "pins"
    std::size_t (*size)(const SceneDescription& scene);
    void (*renew)(SceneDescription& scene, std::size_t count);  ///< to `count` default elements
};

/// Every key, in the order of the reference.
std::span<const SceneKey> scene_keys();

/// @param key dotted, with "[]" for an index: "pins[].select".  @return null: no such key.
const SceneKey* find_scene_key(std::string_view key);

/// Every list of tables.
std::span<const SceneList> scene_lists();

/// The list that a key with an index stands in ("pins" of "pins[].select"); null: in none.
const SceneList* list_of_scene_key(std::string_view key);

/// The names that may stand in a section ("cloth", "wind.gust", "pins[]", "" for the whole file);
/// empty where there is no such section.
std::vector<std::string_view> names_in_section(std::string_view section);

/// The key or section that `name`, found in `section`, was probably meant to be: one of the same
/// section, or one of like name elsewhere. Empty where none is near.
std::string nearest_scene_key(std::string_view section, std::string_view name);

/// "two numbers", "string", ...
std::string_view type_name(const SceneKey& key);

/// The reference of all keys as Markdown tables, one a section.
std::string scene_keys_markdown();

}  // namespace weft
