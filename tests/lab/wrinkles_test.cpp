// The wrinkling measure on shapes whose angles are known.
#include "lab/wrinkles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/cloth_scenes.h"

namespace weft::lab {
namespace {

Vec3d folded(Vec3d x, double at, double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0, beyond = std::max(x.x - at, 0.0);
    return {std::min(x.x, at) + beyond * std::cos(angle), x.y, beyond * std::sin(angle)};
}

std::vector<Vec3d> rest_of(const ClothModel& cloth) {
    std::vector<Vec3d> positions;
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        positions.push_back(cloth.rest_position(p));
    }
    return positions;
}

TEST(Wrinkles, AFlatSheetHasNone) {
    const ClothModel cloth = build_cloth(test::bare_sheet(6, 5));
    EXPECT_EQ(Wrinkles(cloth.surface).angle(rest_of(cloth)), 0.0);
}

TEST(Wrinkles, OneFoldCountsAsFarAsItGoes) {
    // 5 x 4 quads: 2 x 20 triangles with 20 diagonals, 4 x 4 inner upright edges and 5 x 3 level
    // ones; the fold along a column is 4 of them.
    const ClothModel cloth = build_cloth(test::bare_sheet(6, 5, 1.0, 0.8));
    const Wrinkles wrinkles(cloth.surface);
    EXPECT_EQ(wrinkles.edge_count(), 20u + 16u + 15u);
    for (const double degrees : {30.0, 90.0, 150.0}) {
        std::vector<Vec3d> positions = rest_of(cloth);
        for (Vec3d& x : positions) x = folded(x, 0.4, degrees);
        EXPECT_NEAR(wrinkles.angle(positions), degrees * std::sqrt(4.0 / 51.0), 1e-9);
    }
}

TEST(Wrinkles, IsTheSameOnAMeshOfTheGrid) {
    SceneDescription scene = test::bare_sheet(6, 5);
    const ClothModel grid = build_cloth(scene);
    test::make_mesh_of_grid(scene);
    const ClothModel mesh = build_cloth(scene);
    std::vector<Vec3d> positions = rest_of(grid);
    for (Vec3d& x : positions) x = folded(x, 0.4, 40.0);
    EXPECT_NEAR(Wrinkles(mesh.surface).angle(positions), Wrinkles(grid.surface).angle(positions),
                1e-12);
}

TEST(Wrinkles, TrianglesWithoutAreaDoNotCount) {
    const ClothModel cloth = build_cloth(test::bare_sheet(2, 2));
    std::vector<Vec3d> positions(4, Vec3d{1.0, 2.0, 3.0});
    EXPECT_EQ(Wrinkles(cloth.surface).angle(positions), 0.0);
}

TEST(Wrinkles, ReadsStatesByParticle) {
    const ClothModel cloth = build_cloth(test::bare_sheet(5, 3));
    ParticleState<double> state = test::rest_state<double>(cloth);
    state.x.set(cloth.slot(7), state.x[cloth.slot(7)] + Vec3d{0.0, 0.0, 0.05});
    const std::vector<Vec3d> positions = positions_of(cloth, state);
    EXPECT_EQ(positions[7].z, 0.05);
    const Wrinkles wrinkles(cloth.surface);
    EXPECT_GT(wrinkles.angle(cloth, state), 1.0);
    EXPECT_EQ(wrinkles.angle(cloth, state), wrinkles.angle(positions));
}

}  // namespace
}  // namespace weft::lab
