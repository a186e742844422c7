// Sound files, to be damaged.
#pragma once

#include <string>
#include <vector>

namespace weft::fuzz {

struct Seed {
    enum class Kind { scene, invalid_scene, data } kind;
    std::string ending;  ///< ".toml", ".obj", ".ply" or ".npy"
    std::string bytes;
};

/// The shipped scenes, those of scenes/invalid, and data: small meshes in every format that is
/// read, and states to begin with; in this order.
std::vector<Seed> seeds();

}  // namespace weft::fuzz
