#include <cmath>

#include "weft/frame.h"

namespace weft {

void compute_normals(const Surface& surface, std::span<const Vec3d> positions,
                     std::span<Vec3f> normals) {
    for (Vec3f& normal : normals) normal = {};
    for (const auto& triangle : surface.triangles) {
        const std::uint32_t a = surface.particle(triangle[0]);
        const std::uint32_t b = surface.particle(triangle[1]);
        const std::uint32_t c = surface.particle(triangle[2]);
        const Vec3f twice_area_normal =
            vec3_cast<float>(cross(positions[b] - positions[a], positions[c] - positions[a]));
        normals[a] += twice_area_normal;
        normals[b] += twice_area_normal;
        normals[c] += twice_area_normal;
    }
    for (Vec3f& normal : normals) {
        const float norm = length(normal);
        normal = norm > 0 ? normal / norm : Vec3f{};
    }
}

}  // namespace weft
