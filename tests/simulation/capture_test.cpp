// What a captured frame holds: what was asked for, and nothing else.
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

SceneDescription small_flag(Precision precision, bool mesh) {
    SceneDescription scene;
    scene.cloth.grid.resolution = {13, 9};
    scene.integrator.precision = precision;
    scene.pins = {{ParticleSelection{{0, 13, 26}}, {}}};
    if (mesh) make_mesh_of_grid(scene);
    return scene;
}

template <typename Visit>
void for_each_run(const Visit& visit) {
    for (const bool mesh : {false, true}) {
        for (const Precision precision : {Precision::f32, Precision::f64}) {
            Simulation simulation(small_flag(precision, mesh));
            for (int n = 0; n < 3; ++n) EXPECT_TRUE(simulation.advance_frame().ok());
            visit(simulation, precision);
        }
    }
}

TEST(Capture, FillsAllButRoundedPositionsUnlessTold) {
    for_each_run([](const Simulation& simulation, Precision) {
        FrameBuffer buffer;
        simulation.capture(buffer);
        EXPECT_EQ(buffer.index, 3u);
        EXPECT_EQ(buffer.time, simulation.time());
        EXPECT_EQ(buffer.positions.size(), 117u);
        EXPECT_EQ(buffer.velocities.size(), 117u);
        EXPECT_EQ(buffer.normals.size(), 117u);
        EXPECT_TRUE(buffer.rounded_positions.empty());
        EXPECT_GT(length(buffer.velocities[60]), 0.0);
        for (const Vec3f normal : buffer.normals) EXPECT_NEAR(length(normal), 1.0f, 1e-6f);
    });
}

TEST(Capture, FillsWhatIsNeededAndEmptiesTheRest) {
    for_each_run([](const Simulation& simulation, Precision precision) {
        FrameBuffer all, one;
        simulation.capture(all);
        simulation.capture(one);
        simulation.capture(
            one,
            {.positions = false, .velocities = false, .normals = false, .rounded_positions = true});
        EXPECT_TRUE(one.positions.empty());
        EXPECT_TRUE(one.velocities.empty());
        EXPECT_TRUE(one.normals.empty());
        ASSERT_EQ(one.rounded_positions.size(), 117u);
        bool exact = true;
        for (std::size_t p = 0; p < 117; ++p) {
            EXPECT_EQ(one.rounded_positions[p], vec3_cast<float>(all.positions[p]));
            exact &= vec3_cast<double>(one.rounded_positions[p]) == all.positions[p];
        }
        EXPECT_EQ(exact, precision == Precision::f32);  // a float run has floats

        simulation.capture(one, {.positions = false, .normals = false});
        EXPECT_TRUE(one.positions.empty());
        EXPECT_TRUE(one.rounded_positions.empty());
        EXPECT_EQ(one.velocities, all.velocities);
        simulation.capture(one, {.positions = false, .velocities = false});
        EXPECT_TRUE(one.velocities.empty());
        EXPECT_EQ(one.normals, all.normals);
    });
}

TEST(FrameNeeds, OfSeveralAreThoseOfAny) {
    constexpr FrameNeeds none{.positions = false, .velocities = false, .normals = false};
    constexpr FrameNeeds rounded{
        .positions = false, .velocities = false, .normals = false, .rounded_positions = true};
    constexpr FrameNeeds both =
        none | rounded | FrameNeeds{.positions = false, .velocities = false};
    EXPECT_FALSE(both.positions);
    EXPECT_FALSE(both.velocities);
    EXPECT_TRUE(both.normals);
    EXPECT_TRUE(both.rounded_positions);
}

}  // namespace
}  // namespace weft::test
