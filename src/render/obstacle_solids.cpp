// Building balls and plates.
#include "render/obstacle_solids.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace weft {

namespace {

/// Matt paints that go with the grey ground and the sky, linear: clay, sage, ochre, slate.
constexpr std::array<glm::vec3, 4> paints{
    {{0.33F, 0.11F, 0.055F}, {0.13F, 0.20F, 0.11F}, {0.36F, 0.22F, 0.06F}, {0.09F, 0.14F, 0.21F}}};
constexpr glm::vec3 plate_paint{0.27F, 0.26F, 0.235F};
constexpr float tile_contrast = 0.10F;

constexpr int plate_tiles = 20;          // a side
constexpr float plate_half_side = 1.1F;  // of the stage's size

void add_ball(Solid& solid, const SphereObstacle& sphere, glm::vec3 colour, bool fine) {
    const int rings = fine ? 48 : 16, sides = fine ? 96 : 32;
    const glm::vec3 centre = to_glm(sphere.centre);
    const auto radius = static_cast<float>(sphere.radius);
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= rings; ++i) {
        const float angle =
            std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(rings);
        profile.push_back({-radius * std::cos(angle), radius * std::sin(angle)});
    }
    const std::size_t first = solid.vertices.size();
    add_turned_body(solid, centre, {0, 1, 0}, profile, colour, sides);
    for (std::size_t i = first; i < solid.vertices.size(); ++i)
        solid.vertices[i].normal = (solid.vertices[i].position - centre) / radius;
}

void add_plate(Solid& solid, const Stage& stage, const PlaneObstacle& plane) {
    const glm::vec3 up = glm::normalize(to_glm(plane.normal));
    const glm::vec3 middle = stage.rest.middle();
    const glm::vec3 centre = middle - glm::dot(middle - to_glm(plane.point), up) * up;
    // One side level, so that the tiles show which way it falls.
    const bool level = std::abs(up.y) > 0.999F;
    const glm::vec3 across =
        glm::normalize(glm::cross(level ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0), up));
    const glm::vec3 along = glm::cross(up, across);
    const float side = 2.0F * plate_half_side * stage.size / static_cast<float>(plate_tiles);
    const auto corner = [&](int i, int j) {
        const float x = static_cast<float>(i) - 0.5F * plate_tiles;
        const float y = static_cast<float>(j) - 0.5F * plate_tiles;
        return centre + side * (x * across + y * along);
    };
    for (int i = 0; i < plate_tiles; ++i)
        for (int j = 0; j < plate_tiles; ++j) {
            const float shade = (i + j) % 2 == 0 ? 1.0F + tile_contrast : 1.0F - tile_contrast;
            const auto base = static_cast<std::uint32_t>(solid.vertices.size());
            for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                solid.vertices.push_back({corner(i + a, j + b), up, shade * plate_paint});
            solid.indices.insert(solid.indices.end(),
                                 {base, base + 1, base + 2, base, base + 2, base + 3});
        }
}

}  // namespace

Solid build_obstacles(const Stage& stage, bool fine) {
    Solid solid;
    std::size_t balls = 0;
    for (const ObstacleDescription& obstacle : stage.obstacles) {
        if (const auto* sphere = std::get_if<SphereObstacle>(&obstacle.shape))
            add_ball(solid, *sphere, paints[balls++ % paints.size()], fine);
        else if (const auto& plane = std::get<PlaneObstacle>(obstacle.shape); !level_height(plane))
            add_plate(solid, stage, plane);
    }
    return solid;
}

std::optional<Box> bounds_of(const Solid& solid) {
    if (solid.vertices.empty()) return std::nullopt;
    Box box{solid.vertices.front().position, solid.vertices.front().position};
    for (const SolidVertex& vertex : solid.vertices) box = box.grown_to(vertex.position);
    return box;
}

}  // namespace weft
