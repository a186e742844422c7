// Planning the stage from the first frame of a cloth.
#include "render/stage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "render/mast.h"

namespace weft {

namespace {

constexpr float stretch = 1.05F;  // a cloth under load reaches a little beyond its rest lengths

/// The cloth in the first frame, by vertex.
struct RestCloth {
    std::vector<glm::vec3> points;  // [vertex], [m]
    const Surface* surface = nullptr;
};

RestCloth rest_cloth(const Surface& surface, std::span<const Vec3d> positions) {
    RestCloth cloth{{}, &surface};
    cloth.points.reserve(surface.vertex_count());
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex)
        cloth.points.push_back(to_glm(positions[surface.particle(vertex)]));
    return cloth;
}

Box bounds_of(std::span<const glm::vec3> points) {
    if (points.empty()) return {};
    Box box{points.front(), points.front()};
    for (const glm::vec3& point : points) box = box.grown_to(point);
    return box;
}

/// The points whose `value` is within `tolerance` of the greatest.
template <typename Value>
std::vector<glm::vec3> uppermost(const RestCloth& cloth, float tolerance, Value value) {
    float greatest = -std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < cloth.points.size(); ++i) greatest = std::max(greatest, value(i));
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < cloth.points.size(); ++i)
        if (value(i) >= greatest - tolerance) points.push_back(cloth.points[i]);
    return points;
}

/// Level direction that the front of the cloth faces; for a lying cloth the one from its upper
/// edge (greatest v) to its lower, which is where its front shows once it hangs.
glm::vec3 front_direction(const RestCloth& cloth, bool lying) {
    glm::vec3 sum(0.0F);
    float total = 0.0F;
    const auto& uvs = cloth.surface->uvs;
    for (const auto& [a, b, c] : cloth.surface->triangles) {
        const glm::vec3 ab = cloth.points[b] - cloth.points[a];
        const glm::vec3 ac = cloth.points[c] - cloth.points[a];
        // Solving for the direction in which v falls needs only its sign and weight by area.
        const float ab_u = uvs[b][0] - uvs[a][0], ac_u = uvs[c][0] - uvs[a][0];
        const glm::vec3 part = lying ? ab_u * ac - ac_u * ab : glm::cross(ab, ac);
        sum += part;
        total += glm::length(part);
    }
    if (lying) {
        float turned =
            0.0F;  // the sign of the texture's area: mirrored textures turn the direction
        for (const auto& [a, b, c] : cloth.surface->triangles)
            turned += (uvs[b][0] - uvs[a][0]) * (uvs[c][1] - uvs[a][1]) -
                      (uvs[c][0] - uvs[a][0]) * (uvs[b][1] - uvs[a][1]);
        sum *= turned > 0.0F ? -1.0F : 1.0F;
    }
    sum.y = 0.0F;
    const float length = glm::length(sum);
    // A garment closed around its axis faces nowhere: what is left of the sum is rounding.
    return length > 0.01F * total ? sum / length : glm::vec3(0, 0, 1);
}

/// The ends and the middle of a row of points, ordered along its longest side: enough to bound what
/// a cloth fastened there can reach.
std::vector<glm::vec3> spread_of(std::vector<glm::vec3> points) {
    if (points.empty()) return points;
    const Box box = bounds_of(points);
    const glm::vec3 size = box.high - box.low;
    const int axis = size.y >= size.x && size.y >= size.z ? 1 : (size.x >= size.z ? 0 : 2);
    std::sort(points.begin(), points.end(),
              [axis](const glm::vec3& a, const glm::vec3& b) { return a[axis] < b[axis]; });
    return {points.front(), points[points.size() / 2], points.back()};
}

/// The box that bounds the cloth wherever it swings: every point stays within its rest distance of
/// every fastening.
Box reach_of(const RestCloth& cloth, const std::vector<glm::vec3>& fastenings) {
    Box reach = bounds_of(cloth.points);
    for (const glm::vec3& point : cloth.points) {
        Box ball{glm::vec3(-std::numeric_limits<float>::infinity()),
                 glm::vec3(std::numeric_limits<float>::infinity())};
        for (const glm::vec3& fastening : fastenings) {
            const glm::vec3 radius(stretch * glm::distance(point, fastening));
            ball.low = glm::max(ball.low, fastening - radius);
            ball.high = glm::min(ball.high, fastening + radius);
        }
        if (!fastenings.empty()) reach = reach.grown_to(ball.low).grown_to(ball.high);
    }
    return reach;
}

/// Rightward, upward and toward the front: the axes in which the view is planned.
glm::mat3 stage_axes(const Stage& stage) {
    const glm::vec3 up(0, 1, 0);
    return {glm::cross(up, stage.front), up, stage.front};
}

/// A lying cloth falls and swings through below its fastened edge: the arc of its free edge, wider
/// below where its weight stretches it most.
std::vector<glm::vec3> swing_arc(glm::vec3 half, float top, float ground) {
    std::vector<glm::vec3> points;
    constexpr int steps = 12;
    const float length = 2.0F * half.z;
    for (int i = 0; i <= steps; ++i) {
        const float angle =
            std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(steps);
        const float drop = std::sin(angle), radius = length * (1.0F + 0.6F * drop * drop);
        const float height = std::max(top - radius * drop, ground);
        for (const float side : {-half.x, half.x})
            points.emplace_back(side, height, radius * std::cos(angle) - half.z);
    }
    return points;
}

/// The allowance for a cloth that hangs or flies; `half` is half its size at rest.
std::vector<glm::vec3> hanging_box(const Stage& stage, glm::vec3 half) {
    Box box{{-half.x, stage.rest.low.y, -half.z}, {half.x, stage.rest.high.y, half.z}};
    // With a mast it flaps to both sides and droops at its end, else it sags and sways.
    const float sway = stage.mast ? 0.5F * half.x : 0.6F * half.y;
    const float droop = stage.mast ? 0.5F * half.x : 0.1F * half.y;
    box.low.y = std::max(stage.reach.low.y, box.low.y - droop);
    box.low.z -= sway;
    box.high.z += sway;
    if (stage.mast) box.high.x += 0.06F * half.x;
    const auto corners = box.corners();
    return {corners.begin(), corners.end()};
}

/// How far a lying cloth falls until its middle part meets the obstacle [m]; far, where the
/// obstacle is small beside the cloth or stands elsewhere. A level floor holds no cloth up.
float way_to(const ObstacleDescription& obstacle, const Stage& stage) {
    constexpr float far = std::numeric_limits<float>::infinity();
    const glm::vec3 middle = stage.rest.middle();
    if (const auto* sphere = std::get_if<SphereObstacle>(&obstacle.shape)) {
        const glm::vec3 centre = to_glm(sphere->centre);
        const auto radius = static_cast<float>(sphere->radius);
        const float aside = glm::distance(glm::vec2(centre.x, centre.z), {middle.x, middle.z});
        const bool bears = radius > 0.08F * stage.size && aside < 0.35F * stage.size;
        return bears && centre.y < middle.y ? middle.y - centre.y - radius : far;
    }
    const auto& plane = std::get<PlaneObstacle>(obstacle.shape);
    const glm::vec3 normal = glm::normalize(to_glm(plane.normal));
    if (level_height(plane) || normal.y < 0.1F) return far;
    const float way = glm::dot(middle - to_glm(plane.point), normal) / normal.y;
    return way > 0.0F ? way : far;
}

/// Whether a lying cloth comes to drape over an obstacle, and does not swing.
bool lies_over_obstacle(const Stage& stage) {
    return stage.lying && std::any_of(stage.obstacles.begin(), stage.obstacles.end(),
                                      [&](const ObstacleDescription& obstacle) {
                                          return way_to(obstacle, stage) < 0.5F * stage.size;
                                      });
}

/// The cloth as it lies, and the floor below its inner part, where it comes to hang.
std::vector<glm::vec3> draped_box(const Stage& stage, float ground) {
    const auto corners = stage.rest.corners();
    std::vector<glm::vec3> points(corners.begin(), corners.end());
    for (const glm::vec3& corner : corners) {
        glm::vec3 below = glm::mix(stage.rest.middle(), corner, 0.7F);
        below.y = std::max(ground, stage.rest.low.y - 0.5F * stage.size);
        points.push_back(below);
    }
    return points;
}

/// Points all over the balls.
void add_balls(const Stage& stage, std::vector<glm::vec3>& points) {
    for (const ObstacleDescription& obstacle : stage.obstacles) {
        const auto* sphere = std::get_if<SphereObstacle>(&obstacle.shape);
        if (sphere == nullptr) continue;
        for (int i = 0; i < 27; ++i) {
            const glm::vec3 way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            if (i == 13) continue;  // the middle
            points.push_back(to_glm(sphere->centre) +
                             static_cast<float>(sphere->radius) * glm::normalize(way));
        }
    }
}

/// What the camera shows. Showing all of the reach would make the cloth small for the sake of
/// places it hardly comes to, so each way of hanging has its own allowance.
std::vector<glm::vec3> view_corners(const Stage& stage, float ground) {
    const glm::mat3 axes = stage_axes(stage);
    const glm::vec3 size = stage.rest.high - stage.rest.low;
    const glm::vec3 half = 0.5F * glm::vec3(glm::dot(size, glm::abs(axes[0])), size.y,
                                            glm::dot(size, glm::abs(axes[2])));
    const glm::vec3 middle = stage.rest.middle();
    if (lies_over_obstacle(stage)) return draped_box(stage, ground);
    std::vector<glm::vec3> corners =
        stage.lying ? swing_arc(half, stage.rest.high.y, ground) : hanging_box(stage, half);
    for (glm::vec3& corner : corners) corner = glm::vec3(middle.x, 0, middle.z) + axes * corner;
    if (stage.mast && !stage.mast->level)
        corners.push_back(stage.mast->top + glm::vec3(0, 4.0F * stage.mast->radius, 0));
    return corners;
}

/// The floor lies at height 0 where the cloth stays above it and is near it, else below the reach.
float ground_height(const Stage& stage) {
    const float lowest = stage.reach.low.y;
    const bool natural = lowest >= 0.0F && lowest <= 2.0F * stage.size;
    return natural ? 0.0F : lowest - 0.1F * stage.size;
}

}  // namespace

std::array<glm::vec3, 8> Box::corners() const {
    std::array<glm::vec3, 8> result;
    for (unsigned i = 0; i < 8; ++i)
        result[i] = {(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y,
                     (i & 4U) != 0 ? high.z : low.z};
    return result;
}

std::optional<float> level_height(const PlaneObstacle& plane) {
    const glm::vec3 normal = glm::normalize(to_glm(plane.normal));
    if (!(normal.y > 0.99999F)) return std::nullopt;
    return static_cast<float>(plane.point.y);
}

std::optional<float> floor_height(const Stage& stage) {
    std::optional<float> highest;
    for (const ObstacleDescription& obstacle : stage.obstacles) {
        const auto* plane = std::get_if<PlaneObstacle>(&obstacle.shape);
        const auto height = plane != nullptr ? level_height(*plane) : std::nullopt;
        if (height) highest = std::max(highest.value_or(*height), *height);
    }
    return highest ? highest : stage.ground;
}

Stage plan_stage(const Surface& surface, std::span<const Vec3d> positions,
                 const RenderDescription& render, std::span<const ObstacleDescription> obstacles) {
    const RestCloth cloth = rest_cloth(surface, positions);
    Stage stage;
    stage.rest = bounds_of(cloth.points);
    const glm::vec3 size = stage.rest.high - stage.rest.low;
    stage.size = std::max(glm::length(size), 1e-3F);
    stage.lying = size.y < 0.25F * stage.size;
    stage.front = front_direction(cloth, stage.lying);

    const auto left = uppermost(cloth, 1e-3F, [&](std::size_t i) { return -surface.uvs[i][0]; });
    const auto upper =
        stage.lying
            ? uppermost(cloth, 1e-3F, [&](std::size_t i) { return surface.uvs[i][1]; })
            : uppermost(cloth, 0.02F * size.y, [&](std::size_t i) { return cloth.points[i].y; });
    stage.reach = reach_of(cloth, spread_of(render.mast ? left : upper));
    stage.obstacles.assign(obstacles.begin(), obstacles.end());
    if (render.ground) stage.ground = ground_height(stage);
    const float ground = floor_height(stage).value_or(ground_height(stage));
    if (render.mast) stage.mast = plan_mast(left, stage.rest, ground);
    stage.view = view_corners(stage, ground);
    add_balls(stage, stage.view);

    // The sun stands high, to the left and in front: it grazes a hanging cloth, so folds show.
    stage.to_sun = glm::normalize(stage_axes(stage) * glm::vec3(-0.74F, 0.80F, 0.46F));
    return stage;
}

}  // namespace weft
