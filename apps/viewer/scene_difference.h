// What an edit of a scene means for a cloth that flies.
#pragma once

#include "weft/scene.h"

namespace weft::viewer {

struct SceneDifference {
    bool cloth = false;    ///< another cloth, start, frame rate or precision: it begins anew
    bool physics = false;  ///< moves otherwise
    bool shape = false;    ///< another ClothShape: pins, mass, springs, stage
    bool obstacles = false;
};

/// Spheres that only moved do not make another shape.
SceneDifference difference(const SceneDescription& from, const SceneDescription& to);

}  // namespace weft::viewer
