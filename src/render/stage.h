// The place a cloth is shown in: what of space it may reach, its mast, the ground, the sun. All of
// it is fixed by the rest state, so that camera and light stand still during a recording.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "weft/frame.h"
#include "weft/scene.h"

namespace weft {

inline glm::vec3 to_glm(Vec3d v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// A box with its sides along the axes [m].
struct Box {
    glm::vec3 low{0.0F}, high{0.0F};

    [[nodiscard]] glm::vec3 middle() const { return 0.5F * (low + high); }
    [[nodiscard]] std::array<glm::vec3, 8> corners() const;
    [[nodiscard]] Box grown_to(glm::vec3 point) const {
        return {glm::min(low, point), glm::max(high, point)};
    }
};

/// A round pole from `foot` to `top`; a level one carries a finial at both ends.
struct Pole {
    glm::vec3 foot{0.0F}, top{0.0F};  ///< [m]
    float radius = 0.0F;              ///< [m]
    bool level = false;
    std::vector<glm::vec3> ties;      ///< where on the axis the cloth is tied [m]
    glm::vec3 toward_cloth{1, 0, 0};  ///< unit vector across the pole
};

struct Stage {
    Box rest;                     ///< of the cloth in the first frame
    Box reach;                    ///< what a cloth fastened as supposed could reach
    std::vector<glm::vec3> view;  ///< corners of what an automatic camera shows [m]
    glm::vec3 front{0, 0, 1};     ///< level unit vector that the cloth faces
    bool lying = false;           ///< the cloth starts level, and is seen from higher up
    float size = 1.0F;            ///< diagonal of `rest` [m]
    std::optional<float> ground;  ///< height of the floor where no obstacle is it [m]
    glm::vec3 to_sun{0, 1, 0};    ///< unit vector
    std::optional<Pole> mast;
    std::vector<ObstacleDescription> obstacles;  ///< drawn, with shadows
};

/// The height of a plane that is level with its normal upward [m]; nothing for others.
std::optional<float> level_height(const PlaneObstacle& plane);

/// The height of the floor: that of the highest level plane among the obstacles, else the stage's
/// own, if it has one [m].
std::optional<float> floor_height(const Stage& stage);

/// Plans the stage from the first frame. A frame does not say what holds the cloth: with a mast it
/// is taken to be fastened along its left edge (u = 0), else along its upper edge.
/// @param positions [particle] of the first frame [m].
/// @param obstacles lie within what an automatic camera shows, planes aside. A level plane with its
///                  normal upward is the ground.
Stage plan_stage(const Surface& surface, std::span<const Vec3d> positions,
                 const RenderDescription& render,
                 std::span<const ObstacleDescription> obstacles = {});

}  // namespace weft
