// Small cloths above obstacles, and what is asked of them.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "support/cloth_scenes.h"
#include "weft/simulation.h"

namespace weft::test {

/// A level sheet of n x n particles, half a metre wide, at a height; a mild fabric.
inline SceneDescription level_sheet(int n, double height) {
    SceneDescription scene = bare_sheet(n, n, 0.5, 0.5);
    scene.cloth.grid.plane = Plane::xz;
    scene.cloth.grid.origin = {-0.25, height, -0.25};
    add_dashpots(scene, 1e-3);
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.integrator.method = "velocity-verlet";
    return scene;
}

inline ObstacleDescription floor_with(double friction, double gap = 0.0) {
    return {PlaneObstacle{}, friction, gap};
}

inline const std::vector<std::string>& methods_in_contact() {
    static const std::vector<std::string> methods{"symplectic-euler",
                                                  "velocity-verlet",
                                                  "verlet",
                                                  "time-corrected-verlet",
                                                  "rk4",
                                                  "yoshida4",
                                                  "dopri5",
                                                  "implicit-euler",
                                                  "trapezoidal",
                                                  "bdf2",
                                                  "tr-bdf2",
                                                  "baraff-witkin",
                                                  "xpbd",
                                                  "vbd",
                                                  "projective-dynamics"};
    return methods;
}

inline Vec3d mean(const std::vector<Vec3d>& vectors) {
    Vec3d sum;
    for (const Vec3d& v : vectors) sum += v;
    return sum / static_cast<double>(vectors.size());
}

inline double longest(const std::vector<Vec3d>& vectors) {
    double longest = 0.0;
    for (const Vec3d& v : vectors) longest = std::max(longest, length(v));
    return longest;
}

/// How far the cloth is outside an obstacle, least of all particles; its gap is not counted [m].
inline double clearance(const std::vector<Vec3d>& positions, const ObstacleDescription& obstacle) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3d& x : positions) {
        if (const auto* const sphere = std::get_if<SphereObstacle>(&obstacle.shape)) {
            least = std::min(least, length(x - sphere->centre) - sphere->radius);
        } else {
            const auto& plane = std::get<PlaneObstacle>(obstacle.shape);
            least = std::min(least, dot(x - plane.point, plane.normal) / length(plane.normal));
        }
    }
    return least;
}

}  // namespace weft::test
