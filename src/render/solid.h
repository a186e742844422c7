// Triangles of round bodies.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace weft {

/// A corner of a solid: what the vertex shader reads.
struct SolidVertex {
    glm::vec3 position;  ///< [m]
    glm::vec3 normal;    ///< unit, outward
    glm::vec3 colour;    ///< linear
};

struct Solid {
    std::vector<SolidVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise outside
};

/// A point of a profile that is turned around an axis.
struct ProfilePoint {
    float along = 0.0F;   ///< from the start of the axis [m]
    float radius = 0.0F;  ///< [m]
};

/// Adds the body that a profile sweeps when it turns around the axis from `start` along the unit
/// vector `axis`. Normals are smooth along the profile; a sharp edge is two points in one place.
/// @param sides of the polygon that stands for a circle.
void add_turned_body(Solid& solid, glm::vec3 start, glm::vec3 axis,
                     const std::vector<ProfilePoint>& profile, glm::vec3 colour, int sides = 32);

/// Adds a ring of round section around `centre`.
/// @param ring_radius of its middle line; @param radius of its section [m].
void add_ring(Solid& solid, glm::vec3 centre, glm::vec3 axis, float ring_radius, float radius,
              glm::vec3 colour, int sides = 32);

}  // namespace weft
