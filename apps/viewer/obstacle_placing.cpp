#include "viewer/obstacle_placing.h"

#include <algorithm>

namespace weft::viewer {

namespace {

struct Bounds {
    Vec3d low, high;
    [[nodiscard]] Vec3d size() const { return high - low; }
    [[nodiscard]] Vec3d middle() const { return 0.5 * (low + high); }
    [[nodiscard]] double largest() const { return std::max({size().x, size().y, size().z, 1e-3}); }
};

Bounds bounds_of(std::span<const Vec3d> positions) {
    if (positions.empty()) return {};
    Bounds bounds{positions.front(), positions.front()};
    for (const Vec3d& p : positions) {
        bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y),
                      std::min(bounds.low.z, p.z)};
        bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y),
                       std::max(bounds.high.z, p.z)};
    }
    return bounds;
}

}  // namespace

ObstacleDescription sphere_beside(std::span<const Vec3d> positions) {
    const Bounds bounds = bounds_of(positions);
    const Vec3d size = bounds.size();
    SphereObstacle sphere;
    sphere.radius = 0.15 * bounds.largest();
    sphere.centre = bounds.middle();
    const double away = 1.1 * sphere.radius;
    if (size.y <= std::min(size.x, size.z)) {
        sphere.centre.y = bounds.low.y - away;
    } else if (size.z <= size.x) {
        sphere.centre.z = bounds.high.z + away;
    } else {
        sphere.centre.x = bounds.high.x + away;
    }
    ObstacleDescription obstacle;
    obstacle.shape = sphere;
    return obstacle;
}

ObstacleDescription plane_below(std::span<const Vec3d> positions) {
    const Bounds bounds = bounds_of(positions);
    PlaneObstacle plane;
    plane.point = bounds.middle();
    plane.point.y = bounds.low.y - 0.1 * bounds.largest();
    ObstacleDescription obstacle;
    obstacle.shape = plane;
    return obstacle;
}

}  // namespace weft::viewer
