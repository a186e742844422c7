// What the mouse would take hold of: pins before cloth and spheres, planes by their handles.
#pragma once

#include <span>
#include <vector>

#include "viewer/picking.h"
#include "viewer/pointer_gesture.h"
#include "viewer/shown_cloth.h"
#include "viewer/view_area.h"

namespace weft::viewer {

/// A plane has no end: it would take every press on the ground, and leave none to turn the camera.
/// So it is moved by a handle that stands on it, in front of the cloth.
struct PlaneHandle {
    std::size_t obstacle = 0;
    glm::vec3 middle{0.0F};     ///< of the handle [m]
    glm::vec3 normal{0, 1, 0};  ///< unit
    float length = 0.1F;        ///< of each of its two arrows, up to the plane and away from it [m]
};
std::vector<PlaneHandle> plane_handles(std::span<const ObstacleDescription> obstacles,
                                       const Stage& stage);

/// A place under the cursor.
struct TouchTarget {
    PointerTarget kind = PointerTarget::nothing;
    std::size_t cloth = 0;     ///< in whose area the cursor is
    std::size_t particle = 0;  ///< of a pin, or the nearest to the point of the cloth
    std::size_t obstacle = 0;
    glm::dvec3 point{0.0};  ///< of cloth, pin or obstacle [m]
};

/// Where the cursor stands among the areas, and the rays that go through it.
struct CursorPlace {
    std::size_t cloth = 0;
    ViewArea area;
    glm::vec2 pixel{0.0F};
    glm::vec2 cursor{0.0F};  ///< see cursor_in()

    CursorPlace(std::size_t in_cloth, const ViewArea& in_area, glm::vec2 at_pixel)
        : cloth(in_cloth), area(in_area), pixel(at_pixel), cursor(cursor_in(in_area, at_pixel)) {}
    [[nodiscard]] Ray ray(const Camera& camera) const {
        return ray_through(camera, cursor, area.aspect());
    }
};

/// @param reach how near to a pin or a handle the cursor has to come [pixels].
TouchTarget target_at(const Shown& shown, const CursorPlace& place, const Camera& camera,
                      float reach);

/// The point of the line through `point` along the unit vector `normal` that the ray comes nearest
/// to; `point` itself where the ray runs along the line.
glm::dvec3 nearest_on_line(const Ray& ray, glm::dvec3 point, glm::dvec3 normal);

}  // namespace weft::viewer
