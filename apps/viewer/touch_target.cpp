// Finding what is under the cursor.
#include "viewer/touch_target.h"

#include <algorithm>
#include <limits>
#include <variant>

namespace weft::viewer {

namespace {

float distance_to_segment(glm::vec2 point, glm::vec2 from, glm::vec2 to) {
    const glm::vec2 along = to - from;
    const float square = glm::dot(along, along);
    const float part =
        square > 0.0F ? std::clamp(glm::dot(point - from, along) / square, 0.0F, 1.0F) : 0.0F;
    return glm::distance(point, from + part * along);
}

std::optional<TouchTarget> handle_at(const Shown& shown, const CursorPlace& place,
                                     const Camera& camera, float reach) {
    std::optional<TouchTarget> found;
    const Stage& stage = shown.cloths[place.cloth].shape->stage;
    for (const PlaneHandle& handle : plane_handles(shown.obstacles, stage)) {
        const glm::vec3 arrow = handle.length * handle.normal;
        const auto low = pixel_of(place.area, camera, handle.middle - arrow);
        const auto high = pixel_of(place.area, camera, handle.middle + arrow);
        if (!low || !high) continue;
        const float away = distance_to_segment(place.pixel, *low, *high);
        if (away > reach) continue;
        reach = away;
        found = TouchTarget{PointerTarget::obstacle, place.cloth, 0, handle.obstacle,
                            glm::dvec3(handle.middle)};
    }
    return found;
}

std::optional<ObstacleHit> pick_sphere(std::span<const ObstacleDescription> obstacles,
                                       const Ray& ray) {
    std::optional<ObstacleHit> nearest;
    for (std::size_t n = 0; n < obstacles.size(); ++n) {
        if (!std::holds_alternative<SphereObstacle>(obstacles[n].shape)) continue;
        auto hit = pick_obstacle(obstacles.subspan(n, 1), ray);
        if (!hit || (nearest && hit->distance >= nearest->distance)) continue;
        hit->obstacle = n;
        nearest = hit;
    }
    return nearest;
}

}  // namespace

std::vector<PlaneHandle> plane_handles(std::span<const ObstacleDescription> obstacles,
                                       const Stage& stage) {
    std::vector<PlaneHandle> handles;
    const glm::vec3 before = stage.rest.middle() + 0.45F * stage.size * stage.front;
    for (std::size_t n = 0; n < obstacles.size(); ++n) {
        const auto* plane = std::get_if<PlaneObstacle>(&obstacles[n].shape);
        if (plane == nullptr) continue;
        const glm::vec3 normal = glm::normalize(to_glm(plane->normal));
        const float above = glm::dot(before - to_glm(plane->point), normal);
        const float length = 0.07F * stage.size;
        handles.push_back({n, before + (1.2F * length - above) * normal, normal, length});
    }
    return handles;
}

TouchTarget target_at(const Shown& shown, const CursorPlace& place, const Camera& camera,
                      float reach) {
    TouchTarget nothing{PointerTarget::nothing, place.cloth, 0, 0, glm::dvec3(0.0)};
    if (!shown.touchable || !shown.cloths[place.cloth].shape) return nothing;
    const ShownCloth& cloth = shown.cloths[place.cloth];
    const ClothShape& shape = *cloth.shape;
    const Ray ray = place.ray(camera);
    const auto on_cloth = pick_cloth(shape.surface, cloth.frame.positions, ray);
    const auto on_sphere = pick_sphere(shown.obstacles, ray);
    constexpr double beyond_all = std::numeric_limits<double>::infinity();
    const double seen = std::min(on_cloth ? on_cloth->distance : beyond_all,
                                 on_sphere ? on_sphere->distance : beyond_all);
    const float half_height = 0.5F * static_cast<float>(place.area.height);
    const auto pin = pick_particle(shape.pinned, cloth.frame.positions, camera, place.cursor,
                                   place.area.aspect(), reach / half_height);
    if (pin) {
        // A pin stands in the cloth, so what hides it has to be clearly before it.
        const glm::dvec3 point = to_double(cloth.frame.positions[*pin]);
        if (glm::distance(point, ray.origin) < seen + 0.05 * shape.stage.size)
            return {PointerTarget::pin, place.cloth, *pin, 0, point};
    }
    if (const auto handle = handle_at(shown, place, camera, reach)) return *handle;
    if (on_cloth && on_cloth->distance <= seen)
        return {PointerTarget::cloth, place.cloth, on_cloth->particle, 0, on_cloth->point};
    if (on_sphere)
        return {PointerTarget::obstacle, place.cloth, 0, on_sphere->obstacle, on_sphere->point};
    return nothing;
}

glm::dvec3 nearest_on_line(const Ray& ray, glm::dvec3 point, glm::dvec3 normal) {
    const glm::dvec3 way = point - ray.origin;
    const double cosine = glm::dot(ray.direction, normal);
    const double square_of_sine = 1.0 - cosine * cosine;
    if (square_of_sine < 1e-3) return point;
    const double along =
        (cosine * glm::dot(way, ray.direction) - glm::dot(way, normal)) / square_of_sine;
    return point + along * normal;
}

}  // namespace weft::viewer
