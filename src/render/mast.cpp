// Planning and building the mast.
#include "render/mast.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft {

namespace {

constexpr glm::vec3 paint{0.80F, 0.79F, 0.76F};  // white lacquer, linear
constexpr glm::vec3 brass{0.78F, 0.50F, 0.16F};
constexpr glm::vec3 rope{0.62F, 0.55F, 0.42F};

/// Where the edge runs from its lower (or first) end to its upper (or last).
std::pair<glm::vec3, glm::vec3> ends_of(std::span<const glm::vec3> edge) {
    const auto by_height = [](const glm::vec3& a, const glm::vec3& b) { return a.y < b.y; };
    const auto [lowest, highest] = std::minmax_element(edge.begin(), edge.end(), by_height);
    const auto farther_from = [&](glm::vec3 point) {
        return [point](const glm::vec3& a, const glm::vec3& b) {
            return glm::distance(point, a) < glm::distance(point, b);
        };
    };
    const glm::vec3 far = *std::max_element(edge.begin(), edge.end(), farther_from(edge.front()));
    const bool level = highest->y - lowest->y < 0.5F * glm::distance(edge.front(), far);
    return level ? std::pair{edge.front(), far} : std::pair{*lowest, *highest};
}

/// A ball on a small collar, starting `along` the axis of a pole.
void add_finial(Solid& solid, glm::vec3 start, glm::vec3 axis, float pole_radius, int sides) {
    const float ball = 2.0F * pole_radius, collar = 1.35F * pole_radius;
    std::vector<ProfilePoint> profile{
        {-0.6F * pole_radius, pole_radius}, {-0.6F * pole_radius, collar},
        {-0.6F * pole_radius, collar},      {0.3F * pole_radius, collar},
        {0.3F * pole_radius, collar},       {0.5F * pole_radius, 0.7F * pole_radius}};
    constexpr int steps = 16;
    for (int i = 2; i <= steps; ++i) {
        const float angle =
            std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(steps);
        profile.push_back(
            {0.4F * pole_radius + ball * (1.0F - std::cos(angle)), ball * std::sin(angle)});
    }
    add_turned_body(solid, start, axis, profile, brass, sides);
}

}  // namespace

Pole plan_mast(std::span<const glm::vec3> edge, const Box& cloth, float ground) {
    auto [first, last] = ends_of(edge);
    const float size = glm::length(cloth.high - cloth.low);
    Pole pole;
    pole.radius = 0.0085F * size;
    if (glm::distance(first, last) < 0.02F * size) last = first + glm::vec3(0, 0.02F * size, 0);
    const glm::vec3 axis = glm::normalize(last - first);
    pole.level = std::abs(axis.y) < 0.5F;

    const glm::vec3 to_cloth = cloth.middle() - 0.5F * (first + last);
    const glm::vec3 cross = to_cloth - glm::dot(to_cloth, axis) * axis;
    const float distance = glm::length(cross);
    pole.toward_cloth = distance > 1e-4F * size ? cross / distance : glm::vec3(1, 0, 0);
    const glm::vec3 offset = -(1.9F * pole.radius) * pole.toward_cloth;  // the rings go between
    const float inset = 0.055F * glm::distance(first, last);
    pole.ties = {first + offset + inset * axis, last + offset - inset * axis};
    pole.top = last + offset + 0.07F * size * axis;
    pole.foot = first + offset - 0.07F * size * axis;
    if (!pole.level) {  // along the axis down to the ground
        const float below = std::max((first.y - ground) / axis.y, 0.0F);
        pole.foot = first + offset - below * axis;
    }
    return pole;
}

Solid build_mast(const Pole& pole, bool fine) {
    Solid solid;
    const int sides = fine ? 32 : 12;
    const glm::vec3 axis = glm::normalize(pole.top - pole.foot);
    add_turned_body(solid, pole.foot, axis,
                    {{0.0F, pole.radius}, {glm::distance(pole.foot, pole.top), pole.radius}}, paint,
                    sides);
    add_finial(solid, pole.top, axis, pole.radius, sides);
    if (pole.level) add_finial(solid, pole.foot, -axis, pole.radius, sides);
    for (const glm::vec3& tie : pole.ties) {
        add_ring(solid, tie, axis, 1.25F * pole.radius, 0.32F * pole.radius, rope, sides);
        // The lashing from the ring into the cloth's edge.
        add_ring(solid, tie + 1.75F * pole.radius * pole.toward_cloth,
                 glm::cross(axis, pole.toward_cloth), 0.8F * pole.radius, 0.2F * pole.radius, rope,
                 sides);
    }
    return solid;
}

}  // namespace weft
