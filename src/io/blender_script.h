// The script that opens a point cache in Blender.
#pragma once

#include <cstddef>
#include <string>

namespace weft {

struct BlenderScene {
    std::string title;       ///< name of the object
    std::string mesh;        ///< OBJ file beside the script
    std::string cache;       ///< PC2 or MDD file beside the script
    std::size_t points = 0;  ///< vertices of both
    std::size_t frames = 1;
    double frames_per_second = 30.0;
};

/// @return a Python script for Blender 3.4 or later: imports the mesh, drives it with the cache
/// from
///         scene frame 1 on, sets the frame rate and range. Use: blender --python SCRIPT
std::string blender_script(const BlenderScene& scene);

/// Blender keeps a frame rate as a whole number over a divisor.
struct BlenderFrameRate {
    int fps = 30;       ///< 1 to 32767
    double base = 1.0;  ///< the rate is fps / base
};
BlenderFrameRate blender_frame_rate(double frames_per_second);

}  // namespace weft
