#include "io/scene_json.h"

#include <string>
#include <string_view>

#include "io/scene_keys.h"
#include "io/scene_values.h"

namespace weft {

namespace {

using Json = nlohmann::ordered_json;

/// Puts `value` at a dotted key, making the objects on the way.
void put(Json& object, std::string_view key, Json value) {
    Json* node = &object;
    for (std::size_t dot = key.find('.'); dot != std::string_view::npos; dot = key.find('.')) {
        node = &(*node)[std::string(key.substr(0, dot))];
        key.remove_prefix(dot + 1);
    }
    (*node)[std::string(key)] = std::move(value);
}

}  // namespace

Json scene_to_json(const SceneDescription& scene) {
    SceneDescription copy = scene;  // the table's access is to what can be written
    const auto applies = [&](const SceneKey& row, std::size_t index) {
        return !row.applies || row.applies(scene, index);
    };
    Json object = Json::object();
    for (const SceneKey& row : scene_keys()) {
        const SceneList* list = list_of_scene_key(row.key);
        if (!list) {
            if (applies(row, 0)) put(object, row.key, scene_value_json(row, copy, 0));
            continue;
        }
        Json& elements = object[std::string(list->name)];
        if (elements.is_null()) elements = Json::array();
        const std::string_view name = row.key.substr(row.key.find('.') + 1);
        for (std::size_t index = 0; index < list->size(scene); ++index) {
            if (!applies(row, index)) continue;
            put(elements[index], name, scene_value_json(row, copy, index));
        }
    }
    return object;
}

}  // namespace weft
