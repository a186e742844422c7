// What of a scene a running simulation can take on, and how much that changes.
#pragma once

#include "weft/scene.h"

namespace weft {

struct SceneChange {
    bool obstacles = false;
    bool integrator = false;
    bool forces = false;  ///< gravity, drag, wind, what is measured of them
    bool cloth = false;   ///< material or pins: springs and masses become others
};

/// @throws Error (usage) naming the key where cloth, start, frame rate or precision differ.
SceneChange scene_change(const SceneDescription& from, const SceneDescription& to);

}  // namespace weft
