// Triangles of round bodies, by turning a profile.
#include "render/solid.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace weft {

namespace {

/// Two unit vectors that make a right-handed frame with `axis`.
std::pair<glm::vec3, glm::vec3> across(glm::vec3 axis) {
    const glm::vec3 other = std::abs(axis.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 first = glm::normalize(glm::cross(other, axis));
    return {first, glm::cross(axis, first)};
}

/// Outward normal of the profile at point i, as (along, radius) components.
glm::vec2 profile_normal(const std::vector<ProfilePoint>& profile, std::size_t i) {
    glm::vec2 normal(0.0F);
    const auto add_side = [&](std::size_t from, std::size_t to) {
        const glm::vec2 side{profile[to].along - profile[from].along,
                             profile[to].radius - profile[from].radius};
        const float length = glm::length(side);
        if (length > 0.0F) normal += glm::vec2(-side.y, side.x) / length;
    };
    const auto same = [&](std::size_t a, std::size_t b) {
        return profile[a].along == profile[b].along && profile[a].radius == profile[b].radius;
    };
    if (i > 0 && !same(i - 1, i)) add_side(i - 1, i);
    if (i + 1 < profile.size() && !same(i, i + 1)) add_side(i, i + 1);
    const float length = glm::length(normal);
    return length > 0.0F ? normal / length : glm::vec2(0, 1);
}

}  // namespace

void add_turned_body(Solid& solid, glm::vec3 start, glm::vec3 axis,
                     const std::vector<ProfilePoint>& profile, glm::vec3 colour, int sides) {
    const auto [first, second] = across(axis);
    const auto base = static_cast<std::uint32_t>(solid.vertices.size());
    const auto pieces = static_cast<std::uint32_t>(sides), ring = pieces + 1;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const glm::vec2 normal = profile_normal(profile, i);
        for (int side = 0; side <= sides; ++side) {
            const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(side) /
                                static_cast<float>(sides);
            const glm::vec3 outward = std::cos(angle) * first + std::sin(angle) * second;
            solid.vertices.push_back({start + profile[i].along * axis + profile[i].radius * outward,
                                      normal.x * axis + normal.y * outward, colour});
        }
    }
    for (std::uint32_t i = 0; i + 1 < profile.size(); ++i) {
        for (std::uint32_t side = 0; side < pieces; ++side) {
            const std::uint32_t a = base + i * ring + side, b = a + ring;
            solid.indices.insert(solid.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
    }
}

void add_ring(Solid& solid, glm::vec3 centre, glm::vec3 axis, float ring_radius, float radius,
              glm::vec3 colour, int sides) {
    std::vector<ProfilePoint> profile;
    constexpr int steps = 12;
    for (int i = 0; i <= steps; ++i) {
        const float angle =
            2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(steps);
        profile.push_back({-radius * std::cos(angle), ring_radius + radius * std::sin(angle)});
    }
    add_turned_body(solid, centre, axis, profile, colour, sides);
}

}  // namespace weft
