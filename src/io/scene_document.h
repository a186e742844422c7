// A scene file and the overrides of a command line as one tree of values, each with its place.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/toml_value.h"
#include "weft/error.h"
#include "weft/scene.h"

namespace weft {

struct SceneDocument {
    std::string file;                    ///< in messages, as the user gave it
    TomlValue root;                      ///< a table
    std::vector<std::string> overrides;  ///< "--set KEY=VALUE", for messages
    bool has_cloth = false;  ///< whether the file itself, without overrides, has [cloth]

    /// Where the value of a dotted key ("pins[1].motion[0].time") stands; where the document does
    /// not have it, where the innermost table around it stands; line 0 for the file as a whole.
    [[nodiscard]] TomlPlace locate(std::string_view key) const;

    /// The same in the terms of an error.
    [[nodiscard]] ErrorPlace error_place(TomlPlace place, const std::string& key) const;
};

/// Parses `text`, checks its version, and puts the overrides in place, a later one over an earlier
/// one. An override of material.particle_mass takes the file's mass_per_area away, and the other
/// way round; one of cloth.mesh takes the keys of the grid away; one of an obstacle's sphere takes
/// its plane away, and the other way round.
/// @throws Error (usage), complete with its place.
SceneDocument read_scene_document(std::string_view text, const std::string& file,
                                  std::span<const SceneOverride> overrides);

}  // namespace weft
