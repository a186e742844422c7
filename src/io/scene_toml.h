// A scene as the text of a scene file.
#pragma once

#include <string>

#include "weft/scene.h"

namespace weft {

/// Every key that counts, in the order of the reference, with its unit; paths as they stand in the
/// scene. Numbers read back to the same bits.
/// @throws Error (usage) for a value that a TOML file cannot hold: an integer beyond 63 bits, a
///         path that is not UTF-8.
std::string scene_to_toml(const SceneDescription& scene);

}  // namespace weft
