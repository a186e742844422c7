// From the tree of a scene file to a SceneDescription.
#pragma once

#include "io/scene_document.h"
#include "weft/scene.h"

namespace weft {

/// Fills in a scene from a document: types, words, unknown keys and keys that exclude each other
/// are checked here. Ranges are not, paths stay as written and nothing is loaded.
/// @throws Error (usage) with the key; the place is there for unknown keys only.
SceneDescription read_scene(const SceneDocument& document);

}  // namespace weft
