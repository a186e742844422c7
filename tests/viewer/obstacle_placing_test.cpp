#include <gtest/gtest.h>

#include <vector>

#include "viewer/obstacle_placing.h"

namespace weft::viewer {
namespace {

const SphereObstacle& sphere_of(const ObstacleDescription& obstacle) {
    return std::get<SphereObstacle>(obstacle.shape);
}

void expect_outside(const SphereObstacle& sphere, const std::vector<Vec3d>& positions) {
    for (const Vec3d& p : positions) EXPECT_GT(length(p - sphere.centre), sphere.radius);
}

TEST(ObstaclePlacing, ASphereComesUnderAClothThatLies) {
    const std::vector<Vec3d> cloth{{0, 1, 0}, {2, 1, 0}, {0, 1, 1}, {2, 1.1, 1}, {1, 1, 0.5}};
    const ObstacleDescription obstacle = sphere_beside(cloth);
    const SphereObstacle& sphere = sphere_of(obstacle);
    EXPECT_DOUBLE_EQ(sphere.radius, 0.3);
    EXPECT_DOUBLE_EQ(sphere.centre.x, 1.0);
    EXPECT_LT(sphere.centre.y + sphere.radius, 1.0);
    expect_outside(sphere, cloth);
}

TEST(ObstaclePlacing, ASphereComesInFrontOfAClothThatHangs) {
    const std::vector<Vec3d> cloth{{0, 0, 0}, {2, 0, 0.1}, {0, 1, 0}, {2, 1, 0}, {1, 0.5, 0.05}};
    const ObstacleDescription obstacle = sphere_beside(cloth);
    EXPECT_GT(sphere_of(obstacle).centre.z - sphere_of(obstacle).radius, 0.1);
    expect_outside(sphere_of(obstacle), cloth);
}

TEST(ObstaclePlacing, APlaneComesBelow) {
    const std::vector<Vec3d> cloth{{0, 3, 0}, {2, 3, 1}};
    const PlaneObstacle plane = std::get<PlaneObstacle>(plane_below(cloth).shape);
    EXPECT_DOUBLE_EQ(plane.point.y, 2.8);
    EXPECT_EQ(plane.normal, (Vec3d{0.0, 1.0, 0.0}));
}

}  // namespace
}  // namespace weft::viewer
