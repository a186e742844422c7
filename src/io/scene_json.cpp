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
    constexpr std::string_view pin_keys = "pins[].";
    SceneDescription copy = scene;  // the table's access is to what can be written
    Json object = Json::object();
    for (const SceneKey& row : scene_keys()) {
        if (row.applies && !row.applies(scene)) continue;
        if (!row.key.starts_with(pin_keys)) {
            put(object, row.key, scene_value_json(row, copy, 0));
            continue;
        }
        Json& pins = object["pins"];
        if (pins.is_null()) pins = Json::array();
        for (std::size_t pin = 0; pin < copy.pins.size(); ++pin) {
            put(pins[pin], row.key.substr(pin_keys.size()), scene_value_json(row, copy, pin));
        }
    }
    return object;
}

}  // namespace weft
