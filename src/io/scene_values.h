// From TOML values to the types of scene.h, and from these to JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "io/scene_keys.h"
#include "io/toml_value.h"

namespace weft {

/// Reads the value of one key into the scene. Types and words are checked here, ranges by
/// check_scene.
/// @param path the key with its index, "pins[1].select"; for errors.
/// @param index of the pin or obstacle; read for keys of these only.
/// @throws Error (usage) with the key, the value and what is allowed; without file and line.
void read_scene_value(const SceneKey& key, const std::string& path, const TomlValue& value,
                      SceneDescription& scene, std::size_t index);

/// The value of one key as JSON, shaped as in the scene file.
nlohmann::ordered_json scene_value_json(const SceneKey& key, SceneDescription& scene,
                                        std::size_t index);

}  // namespace weft
