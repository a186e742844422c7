// A cloth that falls on a ball and on the ground: nothing goes through, no energy comes from it,
// and what has come to rest stays so.
#include <gtest/gtest.h>

#include <algorithm>

#include "contact_scenes.h"
#include "support/test_name.h"

namespace weft::test {
namespace {

SceneDescription ball_on_the_ground(const std::string& method, Precision precision) {
    SceneDescription scene = level_sheet(16, 0.45);
    scene.obstacles = {{SphereObstacle{{0.02, 0.2, 0.01}, 0.15}, 0.4, 0.005},
                       floor_with(0.4, 0.005)};
    scene.integrator.method = method;
    scene.integrator.precision = precision;
    return scene;
}

class Dropping : public testing::TestWithParam<std::string> {};

TEST_P(Dropping, OnABallAndTheGroundLosesEnergyAndNeverGoesThrough) {
    for (const Precision precision : {Precision::f32, Precision::f64}) {
        const SceneDescription scene = ball_on_the_ground(GetParam(), precision);
        Simulation simulation(scene);
        FrameBuffer frame;
        double energy = simulation.energy().total();
        const double start = energy;
        double least = energy;
        for (int n = 0; n < 300; ++n) {
            const FrameReport report = simulation.advance_frame();
            ASSERT_TRUE(report.ok()) << report.divergence->message;
            simulation.capture(frame);
            for (const ObstacleDescription& obstacle : scene.obstacles) {
                ASSERT_GT(clearance(frame.positions, obstacle), obstacle.gap - 4e-6) << n;
            }
            energy = simulation.energy().total();
            ASSERT_LT(energy, least + 0.03 * start)
                << n;  // xpbd: one sweep leaves springs stretched
            least = std::min(least, energy);
        }
        EXPECT_LT(energy, 0.75 * start);
        EXPECT_LT(longest(frame.velocities), 0.06);  // its rims still swing
    }
}

INSTANTIATE_TEST_SUITE_P(SlowMethods, Dropping, testing::ValuesIn(methods_in_contact()), test_name);

class Resting : public testing::TestWithParam<std::string> {};

// Five seconds after it was laid on the ground.
TEST_P(Resting, OnTheGroundIsQuiet) {
    for (const Precision precision : {Precision::f32, Precision::f64}) {
        SceneDescription scene = level_sheet(10, 0.005);
        scene.obstacles = {floor_with(0.4, 0.005)};
        scene.integrator.method = GetParam();
        scene.integrator.precision = precision;
        Simulation simulation(scene);
        FrameBuffer frame;
        for (int n = 0; n < 150; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
        simulation.capture(frame);
        const ClothModel cloth = build_cloth(scene);
        EXPECT_LT(longest(frame.velocities), 1e-3);
        for (std::size_t p = 0; p < cloth.particle_count; ++p) {
            ASSERT_LT(length(frame.positions[p] - cloth.rest_position(p)), 1e-5) << p;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Resting, testing::ValuesIn(methods_in_contact()), test_name);

}  // namespace
}  // namespace weft::test
