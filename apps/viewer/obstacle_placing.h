// Where a new obstacle stands. No window.
#pragma once

#include <span>

#include "weft/scene.h"

namespace weft::viewer {

/// A sphere that does not touch the cloth, where one can easily drag it in: under a cloth that
/// lies, in front of one that hangs.
ObstacleDescription sphere_beside(std::span<const Vec3d> positions);
/// A level plane below the cloth.
ObstacleDescription plane_below(std::span<const Vec3d> positions);

}  // namespace weft::viewer
