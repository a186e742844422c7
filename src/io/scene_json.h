// A scene as JSON, every default filled in: what summary.json says was run.
#pragma once

#include <nlohmann/json.hpp>

#include "weft/scene.h"

namespace weft {

/// An object shaped like the scene file, its keys in the order of the reference. What does not
/// count is left out: the grid's keys where there is a mesh, "wind" where there is no air.
nlohmann::ordered_json scene_to_json(const SceneDescription& scene);

}  // namespace weft
