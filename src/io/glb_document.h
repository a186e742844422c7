// The JSON part of a binary glTF file that holds a recording.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace weft {

/// Least and greatest co-ordinates of one shape's positions, as glTF demands of every accessor.
struct GlbBounds {
    std::array<float, 3> low{}, high{};
};

/// Everything the JSON says. The binary part holds, in this order and each on a multiple of 4
/// bytes:
///     indices    uint32 [index_count]
///     uvs        float [vertex_count][2], v downward
///     picture    PNG file
///     shapes     for each: float positions [vertex_count][3], float normals [vertex_count][3];
///                shape 0 is the mesh at rest, the others are differences from it
///     times      float [shape]; absent for a single shape, as the next two are
///     weight places, weight values   uint32, float [shape - 1]: the ones in a table of zeros
struct GlbContent {
    std::string title, generator;
    std::size_t vertex_count = 0, index_count = 0, picture_bytes = 0;
    bool repeat_texture = false;           ///< else it ends at its border
    double frames_per_second = 30.0;       ///< of the recording, before it was thinned
    std::size_t frames_recorded = 1;       ///< likewise
    std::vector<GlbBounds> bounds;         ///< [shape]
    std::vector<std::size_t> frame_index;  ///< [shape], which frame it was
    float last_time = 0.0F;                ///< [s]; the first is first_time
    float first_time = 0.0F;
};

/// @return the JSON, without padding.
std::string glb_json(const GlbContent& content);

/// The next multiple of 4.
constexpr std::uint64_t glb_padded(std::uint64_t size) {
    return (size + 3) / 4 * 4;
}

}  // namespace weft
