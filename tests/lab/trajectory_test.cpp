// Specimens fly as simulations do.
#include "lab/trajectory.h"

#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "support/temporary_study.h"
#include "weft/simulation.h"

namespace weft::lab {
namespace {

using test::no_watch;

SceneDescription swinging_sheet(std::string_view method) {
    SceneDescription scene = test::bare_sheet(6, 5);
    scene.forces.gravity = {0.0, -9.81, 2.0};
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    scene.integrator.method = method;
    scene.integrator.time_step = 1.0 / 512;
    scene.output.frames_per_second = 32.0;
    return scene;
}

TEST(Trajectory, IsTheSimulationsToTheBit) {
    for (const std::string_view method : {"velocity-verlet", "rk4", "verlet"}) {
        const SceneDescription scene = swinging_sheet(method);
        Simulation simulation(scene);
        for (int n = 0; n < 8; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
        FrameBuffer frame;
        simulation.capture(frame);
        Specimen specimen(scene);
        const Flight flight =
            fly(specimen, {method, 1.0 / 512, 128, {}, {}}, specimen.start(), no_watch);
        ASSERT_TRUE(flight.ok()) << flight.failure;
        EXPECT_EQ(flight.state.time, simulation.time());
        for (std::size_t p = 0; p < specimen.particle_count(); ++p) {
            EXPECT_EQ(flight.state.x[specimen.cloth().slot(p)], frame.positions[p]);
            EXPECT_EQ(flight.state.v[specimen.cloth().slot(p)], frame.velocities[p]);
        }
        EXPECT_NEAR(specimen.energy(flight.state).total(), simulation.energy().total(), 1e-12);
    }
}

TEST(Trajectory, EndsWhereItBlowsUpAndSaysWhy) {
    Specimen specimen(swinging_sheet("velocity-verlet"));
    const double limit = specimen.modes().stable_step("velocity-verlet");
    ParticleState<double> start = specimen.start();
    test::disturb(specimen.cloth(), start.x, 1e-3, 1);
    const Flight flight =
        fly(specimen, {"velocity-verlet", 1.5 * limit, 2000, {}, {}}, start, no_watch);
    EXPECT_FALSE(flight.ok());
    EXPECT_LT(flight.steps, 200u);
    EXPECT_NE(flight.failure.find("velocity-verlet diverged in step"), std::string::npos);
}

TEST(Trajectory, ALookMayEndIt) {
    Specimen specimen(swinging_sheet("rk4"));
    const Flight flight = fly(specimen, {"rk4", 1e-3, 100, {}, {}}, specimen.start(), no_watch,
                              [](std::size_t step, const auto&) { return step < 7; });
    EXPECT_TRUE(flight.ok());
    EXPECT_EQ(flight.steps, 7u);
    EXPECT_DOUBLE_EQ(flight.state.time, 7e-3);
}

TEST(Trajectory, CountsWhatImplicitStepsTook) {
    Specimen specimen(swinging_sheet("implicit-euler"));
    const Flight flight =
        fly(specimen, {"implicit-euler", 1e-2, 5, {}, {}}, specimen.start(), no_watch);
    ASSERT_TRUE(flight.ok()) << flight.failure;
    EXPECT_GE(flight.counts.newton_iterations, 5u);
    EXPECT_GT(flight.counts.evaluations, 5u);
}

TEST(Trajectory, StatesPassThroughJsonWithoutLoss) {
    Specimen specimen(swinging_sheet("rk4"));
    const ParticleState<double> state =
        fly(specimen, {"rk4", 1e-3, 50, {}, {}}, specimen.start(), no_watch).state;
    const ParticleState<double> back = state_from_json(
        specimen.cloth(), nlohmann::json::parse(state_to_json(specimen.cloth(), state).dump()));
    EXPECT_EQ(back.time, state.time);
    EXPECT_EQ(rms_distance(specimen.cloth(), state, back), 0.0);
    for (std::size_t p = 0; p < specimen.particle_count(); ++p) {
        EXPECT_EQ(back.v[specimen.cloth().slot(p)], state.v[specimen.cloth().slot(p)]);
    }
}

TEST(Trajectory, DistanceIsTheRootOfTheMeanSquare) {
    Specimen specimen(swinging_sheet("rk4"));
    ParticleState<double> moved = specimen.start();
    const ClothModel& cloth = specimen.cloth();
    moved.x.set(cloth.slot(3), moved.x[cloth.slot(3)] + Vec3d{3.0, 4.0, 0.0});
    EXPECT_NEAR(rms_distance(cloth, specimen.start(), moved), 5.0 / std::sqrt(30.0), 1e-14);
}

}  // namespace
}  // namespace weft::lab
