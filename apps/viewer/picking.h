// What stands under the cursor.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "render/camera.h"
#include "weft/frame.h"
#include "weft/scene.h"

namespace weft::viewer {

inline glm::dvec3 to_double(Vec3d v) {
    return {v.x, v.y, v.z};
}

struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit
};

/// @param cursor from -1 to 1, x rightward, y upward.  @param aspect width over height.
Ray ray_through(const Camera& camera, glm::vec2 cursor, float aspect);

struct ClothHit {
    std::size_t particle = 0;  ///< the corner of the triangle that is nearest to the point
    double distance = 0.0;     ///< along the ray [m]
    glm::dvec3 point{0.0};
};
/// The nearest triangle that the ray meets, from either side.
std::optional<ClothHit> pick_cloth(const Surface& surface, std::span<const Vec3d> positions,
                                   const Ray& ray);

/// The particle among `candidates` that the picture shows nearest to the cursor.
/// @param reach in the unit of cursor's y, half of the picture's height.
std::optional<std::size_t> pick_particle(std::span<const std::uint32_t> candidates,
                                         std::span<const Vec3d> positions, const Camera& camera,
                                         glm::vec2 cursor, float aspect, float reach);

struct ObstacleHit {
    std::size_t obstacle = 0;
    double distance = 0.0;
    glm::dvec3 point{0.0};
};
/// The nearest sphere that the ray enters, or plane that it crosses from either side; planes have
/// no end.
std::optional<ObstacleHit> pick_obstacle(std::span<const ObstacleDescription> obstacles,
                                         const Ray& ray);

/// Where the ray meets the plane through `point` that faces the camera: where a thing that was
/// taken at `point` is dragged to.
glm::dvec3 dragged_point(const Ray& ray, const Camera& camera, glm::dvec3 point);

}  // namespace weft::viewer
