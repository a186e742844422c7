#include "viewer/picking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

namespace weft::viewer {

namespace {

/// A row of a matrix, its last number left out.
glm::dvec3 row_of(const glm::mat4& matrix, int row) {
    return {matrix[0][row], matrix[1][row], matrix[2][row]};
}

/// A particle as seen along the ray, which stands at (0, 0).
struct Seen {
    double u, v, depth;
};

std::vector<Seen> look_along(const Ray& ray, std::span<const Vec3d> positions) {
    const glm::dvec3 d = ray.direction;
    const glm::dvec3 aside = std::abs(d.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(d, aside));
    const glm::dvec3 v = glm::cross(d, u);
    std::vector<Seen> seen(positions.size());
    for (std::size_t p = 0; p < positions.size(); ++p) {
        const glm::dvec3 way = to_double(positions[p]) - ray.origin;
        seen[p] = {glm::dot(way, u), glm::dot(way, v), glm::dot(way, d)};
    }
    return seen;
}

double turn(const Seen& a, const Seen& b) {
    return a.u * b.v - a.v * b.u;
}

/// Along the ray to the triangle; none where the ray passes by it. Neighbours compute the same
/// number of opposite sign for their common edge, so that no ray slips through between them.
std::optional<double> distance_to(const Seen& a, const Seen& b, const Seen& c) {
    if ((a.u > 0 && b.u > 0 && c.u > 0) || (a.u < 0 && b.u < 0 && c.u < 0)) return std::nullopt;
    const double at_c = turn(a, b), at_a = turn(b, c), at_b = turn(c, a);
    const bool inside =
        (at_a >= 0 && at_b >= 0 && at_c >= 0) || (at_a <= 0 && at_b <= 0 && at_c <= 0);
    const double sum = at_a + at_b + at_c;
    if (!inside || sum == 0.0) return std::nullopt;
    return (at_a * a.depth + at_b * b.depth + at_c * c.depth) / sum;
}

/// Along the ray to what it enters or crosses; none where it passes by or lies behind.
struct ObstacleDistance {
    const Ray& ray;

    std::optional<double> operator()(const SphereObstacle& sphere) const {
        const glm::dvec3 way = to_double(sphere.centre) - ray.origin;
        const double along = glm::dot(way, ray.direction);
        const glm::dvec3 aside = way - along * ray.direction;
        const double half_square = sphere.radius * sphere.radius - glm::dot(aside, aside);
        if (half_square < 0.0) return std::nullopt;
        const double distance = along - std::sqrt(half_square);
        return distance > 0.0 ? std::optional(distance) : std::nullopt;
    }
    std::optional<double> operator()(const PlaneObstacle& plane) const {
        const glm::dvec3 normal = to_double(plane.normal);
        const double distance =
            glm::dot(to_double(plane.point) - ray.origin, normal) / glm::dot(ray.direction, normal);
        return distance > 0.0 && std::isfinite(distance) ? std::optional(distance) : std::nullopt;
    }
};

}  // namespace

Ray ray_through(const Camera& camera, glm::vec2 cursor, float aspect) {
    // The matrix's rows are the camera's axes: right and up over the tangents of half its angles,
    // and, for w, forward. Its inverse would lose the direction where near and far are far apart.
    const glm::mat4 matrix = camera.world_to_clip(aspect);
    const glm::dvec3 right = row_of(matrix, 0), up = row_of(matrix, 1);
    const glm::dvec3 direction = row_of(matrix, 3) +
                                 double{cursor.x} / glm::dot(right, right) * right +
                                 double{cursor.y} / glm::dot(up, up) * up;
    return {glm::dvec3(camera.eye), glm::normalize(direction)};
}

std::optional<ClothHit> pick_cloth(const Surface& surface, std::span<const Vec3d> positions,
                                   const Ray& ray) {
    const std::vector<Seen> seen = look_along(ray, positions);
    std::optional<double> nearest;
    std::array<std::uint32_t, 3> corners{};
    for (const auto& triangle : surface.triangles) {
        const std::array<std::uint32_t, 3> abc{surface.particle(triangle[0]),
                                               surface.particle(triangle[1]),
                                               surface.particle(triangle[2])};
        const auto distance = distance_to(seen[abc[0]], seen[abc[1]], seen[abc[2]]);
        if (!distance || !(*distance > 0.0) || (nearest && *distance >= *nearest)) continue;
        nearest = distance;
        corners = abc;
    }
    if (!nearest) return std::nullopt;
    const glm::dvec3 point = ray.origin + *nearest * ray.direction;
    const auto away = [&](std::uint32_t p) {
        return glm::distance(to_double(positions[p]), point);
    };
    const std::uint32_t particle =
        *std::min_element(corners.begin(), corners.end(),
                          [&](std::uint32_t p, std::uint32_t q) { return away(p) < away(q); });
    return ClothHit{particle, *nearest, point};
}

std::optional<std::size_t> pick_particle(std::span<const std::uint32_t> candidates,
                                         std::span<const Vec3d> positions, const Camera& camera,
                                         glm::vec2 cursor, float aspect, float reach) {
    const glm::mat4 matrix = camera.world_to_clip(aspect);
    std::optional<std::size_t> nearest;
    for (const std::uint32_t particle : candidates) {
        const glm::vec4 clip = matrix * glm::vec4(to_glm(positions[particle]), 1.0F);
        if (!(clip.w > 0.0F) || clip.z < -clip.w) continue;  // behind the eye or too near
        const glm::vec2 aside = glm::vec2(clip) / clip.w - cursor;
        const float away = std::hypot(aspect * aside.x, aside.y);
        if (!(away <= reach)) continue;
        nearest = particle;
        reach = away;
    }
    return nearest;
}

std::optional<ObstacleHit> pick_obstacle(std::span<const ObstacleDescription> obstacles,
                                         const Ray& ray) {
    std::optional<ObstacleHit> nearest;
    for (std::size_t n = 0; n < obstacles.size(); ++n) {
        const auto distance = std::visit(ObstacleDistance{ray}, obstacles[n].shape);
        if (!distance || (nearest && *distance >= nearest->distance)) continue;
        nearest = ObstacleHit{n, *distance, ray.origin + *distance * ray.direction};
    }
    return nearest;
}

glm::dvec3 dragged_point(const Ray& ray, const Camera& camera, glm::dvec3 point) {
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    const double distance =
        glm::dot(point - ray.origin, forward) / glm::dot(ray.direction, forward);
    return ray.origin + distance * ray.direction;
}

}  // namespace weft::viewer
