// Changes of a scene that are more than a number: pins, obstacles, methods, fabrics, wind. Each
// gives a scene that check_scene() accepts where it accepts the old one, and changes nothing for a
// particle or an obstacle that does not exist (any more).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "weft/scene.h"

namespace weft::viewer {

/// Pins a particle that is not pinned, where it rests displaced by `offset` [m], or unpins one that
/// is; selectors are written out as particles only where they must be.
SceneDescription with_pin_toggled(const SceneDescription& scene, std::size_t particle,
                                  Vec3d offset);
/// Moves a pinned particle by `shift` [m] for good; its own motion goes on from there. One that is
/// not pinned stays free.
SceneDescription with_pin_moved(const SceneDescription& scene, std::size_t particle, Vec3d shift);
/// Where the particle of a scene's cloth rests [m], before any motion.
/// @throws Error where the scene's cloth cannot be built, as the two above do.
Vec3d rest_position(const SceneDescription& scene, std::size_t particle);

SceneDescription with_obstacle(const SceneDescription& scene, const ObstacleDescription& added);
SceneDescription without_obstacle(const SceneDescription& scene, std::size_t obstacle);
SceneDescription with_obstacle_moved(const SceneDescription& scene, std::size_t obstacle,
                                     Vec3d shift);
SceneDescription with_method(const SceneDescription& scene, std::string_view method);
/// All of the fabric: its mass per area, and its springs per width.
SceneDescription with_fabric(const SceneDescription& scene, std::string_view fabric);
/// In air, still at first, or without any.
SceneDescription with_wind(const SceneDescription& scene, bool wind);
/// With or without gusts in its wind; a scene without wind stays so.
SceneDescription with_gusts(const SceneDescription& scene, bool gusts);
/// With other columns and rows of a grid: particles and steps of the pins' selectors become those
/// that are nearest, so that what was held at a place is held there. The start is the rest state.
SceneDescription with_resolution(const SceneDescription& scene, std::array<int, 2> resolution);

/// The scene that begins with what is on the screen: a state and its time, with all motions of pins
/// and gusts as they are then.
SceneDescription with_start(const SceneDescription& scene, std::span<const Vec3d> positions,
                            std::span<const Vec3d> velocities, double time);

}  // namespace weft::viewer
