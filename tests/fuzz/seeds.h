// Sound files, to be damaged.
#pragma once

#include <string>
#include <vector>

namespace weft::fuzz {

struct Seed {
    enum class Kind { scene, invalid_scene, mesh } kind;
    std::string ending;  ///< ".toml", ".obj" or ".ply"
    std::string bytes;
};

/// The shipped scenes, those of scenes/invalid, and small meshes in every format that is
/// read; in this order.
std::vector<Seed> seeds();

}  // namespace weft::fuzz
