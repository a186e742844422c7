// Whole steps in a frame, the automatic step, times, pins, and setting the state.
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "support/methods.h"
#include "weft/error.h"
#include "weft/integrators.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

SceneDescription stepped(double time_step, double frames_per_second) {
    SceneDescription scene = bare_sheet(4, 4);
    scene.integrator.time_step = time_step;
    scene.output.frames_per_second = frames_per_second;
    return scene;
}

// dt is the frame's length over the smallest whole number of steps that keeps dt <= time_step.
TEST(StepControl, MakesWholeStepsInAFrame) {
    const auto steps = [](double dt, double fps) {
        const Simulation simulation(stepped(dt, fps));
        EXPECT_LE(simulation.time_step(), dt * (1 + 1e-12));
        EXPECT_NEAR(simulation.time_step() * static_cast<double>(simulation.steps_per_frame()),
                    1 / fps, 1e-15);
        return simulation.steps_per_frame();
    };
    EXPECT_EQ(steps(0.001, 30.0), 34u);  // 33.3
    EXPECT_EQ(steps(0.016, 31.25), 2u);
    EXPECT_EQ(steps(0.001, 100.0), 10u);  // exactly, not 11 for rounding
    EXPECT_EQ(steps(1.0 / 30.0, 30.0), 1u);
    EXPECT_EQ(steps(0.1 / 3.0, 30.0), 1u);
    EXPECT_EQ(steps(0.0333, 30.0), 2u);
    EXPECT_EQ(steps(5.0, 30.0), 1u);  // never longer than a frame
    EXPECT_EQ(steps(1e-4, 24.0), 417u);
}

TEST(StepControl, TakesNineTenthsOfTheStableStepByItself) {
    for (const char* method :
         {"velocity-verlet", "verlet", "rk3", "rk4", "symplectic-euler", "yoshida4"}) {
        SceneDescription scene = bare_sheet(6, 6);
        scene.integrator.method = method;
        const Simulation simulation(scene);
        const double wanted = 0.9 * simulation.stable_step(method);
        EXPECT_LE(simulation.time_step(), wanted);
        EXPECT_EQ(simulation.steps_per_frame(),
                  static_cast<std::size_t>(std::ceil(1.0 / 30.0 / wanted)))
            << method;
    }
}

TEST(StepControl, RefusesAutoForAMethodStableAtNoStep) {
    for (const char* method : {"forward-euler", "rk2"}) {
        SceneDescription scene = bare_sheet(4, 4);
        scene.integrator.method = method;
        try {
            const Simulation simulation(scene);
            ADD_FAILURE() << method;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            EXPECT_EQ(error.place().key, "integrator.time_step");
            EXPECT_NE(error.message().find(method), std::string::npos);
            EXPECT_NE(error.message().find("stable at no step"), std::string::npos);
        }
        add_dashpots(scene, 0.01);  // with damping there is a step
        EXPECT_GT(Simulation(scene).steps_per_frame(), 1u);
    }
}

// Steps that were taken by itself hold while the cloth swings and stretches.
TEST(StepControl, KeepsARunStableByItself) {
    SceneDescription scene = bare_sheet(12, 12);
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.cloth.grid.plane = Plane::xz;
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    for (const IntegratorInfo& info : explicit_methods()) {
        if (info.imaginary_limit == 0.0) continue;
        scene.integrator.method = std::string(info.name);
        Simulation simulation(scene);
        const double start = simulation.energy().total();
        for (int n = 0; n < 60; ++n) ASSERT_TRUE(simulation.advance_frame().ok()) << info.name;
        EXPECT_LT(std::abs(simulation.largest_strain().strain), 3.0) << info.name;
        // rk3 and rk4 may lose energy, none may gain.
        EXPECT_LT(simulation.energy().total() - start, 0.05) << info.name;
    }
}

TEST(StepControl, CountsFramesStepsAndTimeExactly) {
    SceneDescription scene = stepped(0.004, 30.0);
    Simulation simulation(scene);
    EXPECT_EQ(simulation.time(), 0.0);
    for (std::size_t n = 1; n <= 90; ++n) {
        const FrameReport report = simulation.advance_frame();
        EXPECT_TRUE(report.ok());
        EXPECT_EQ(report.steps, 9u);
        EXPECT_EQ(report.time_step, simulation.time_step());
        EXPECT_EQ(report.halvings, 0);
        EXPECT_EQ(simulation.frame(), n);
        EXPECT_EQ(simulation.step_count(), 9 * n);
        EXPECT_EQ(simulation.time(), static_cast<double>(n) / 30.0);  // no rounding adds up
    }
}

TEST(StepControl, CapturesTheInitialState) {
    SceneDescription scene = stepped(0.004, 30.0);
    const Simulation simulation(scene);
    FrameBuffer frame;
    simulation.capture(frame);
    const ClothModel cloth = build_cloth(scene);
    EXPECT_EQ(frame.index, 0u);
    EXPECT_EQ(frame.time, 0.0);
    ASSERT_EQ(frame.positions.size(), 16u);
    for (std::size_t p = 0; p < 16; ++p) {
        EXPECT_EQ(frame.positions[p], cloth.rest_position(p));
        EXPECT_EQ(frame.velocities[p], Vec3d{});
        EXPECT_EQ(frame.normals[p], (Vec3f{0.0f, 0.0f, 1.0f}));
    }
}

TEST(StepControl, MovesPinsAsTheirKeyframesSay) {
    for (const IntegratorInfo& info : explicit_methods()) {
        SceneDescription scene = stepped(0.001, 20.0);
        scene.integrator.method = std::string(info.name);
        scene.pins = {{EdgeSelection::top_left, {{0.0, {}}, {1.0, {0.4, 0.1, -0.3}}}},
                      {EdgeSelection::bottom_right, {}}};
        Simulation simulation(scene);
        EXPECT_EQ(simulation.pinned_count(), 2u);
        FrameBuffer frame;
        for (int n = 0; n < 10; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
        simulation.capture(frame);  // at half a second, half way, at 3/2 of the mean speed
        EXPECT_LT(length(frame.positions[0] - 0.5 * Vec3d{0.4, 0.1, -0.3}), 1e-14) << info.name;
        EXPECT_LT(length(frame.velocities[0] - 1.5 * Vec3d{0.4, 0.1, -0.3}), 1e-14) << info.name;
        EXPECT_EQ(frame.positions[15], (Vec3d{1.0, -1.0, 0.0}));
        EXPECT_EQ(frame.velocities[15], Vec3d{});
        EXPECT_GT(length(frame.positions[1] - Vec3d{1.0 / 3, 0, 0}), 0.01)
            << info.name;  // dragged along
    }
}

TEST(SetState, ReplacesAllButThePinned) {
    SceneDescription scene = stepped(0.004, 30.0);
    scene.pins = {{EdgeSelection::top_left, {}}};
    Simulation simulation(scene);
    const std::vector<Vec3d> x(16, {1.0, 2.0, 3.0}), v(16, {4.0, 5.0, 6.0});
    simulation.set_state(x, v);
    FrameBuffer frame;
    simulation.capture(frame);
    EXPECT_EQ(frame.positions[0], Vec3d{});
    EXPECT_EQ(frame.velocities[0], Vec3d{});
    for (std::size_t p = 1; p < 16; ++p) {
        EXPECT_EQ(frame.positions[p], x[p]);
        EXPECT_EQ(frame.velocities[p], v[p]);
    }
}

// A run set to the state of another continues as that one does: to the bit where the method keeps
// nothing between steps.
TEST(SetState, ContinuesAnotherRun) {
    SceneDescription scene = stepped(0.004, 30.0);
    scene.pins = {{EdgeSelection::top_left, {}}};
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.integrator.method = "rk4";
    Simulation first(scene), second(scene);
    FrameBuffer frame;
    for (int n = 0; n < 5; ++n) ASSERT_TRUE(first.advance_frame().ok());
    first.capture(frame);
    second.set_state(frame.positions, frame.velocities);
    EXPECT_EQ(first.state_hash(), second.state_hash());
    ASSERT_TRUE(first.advance_frame().ok());
    ASSERT_TRUE(second.advance_frame().ok());
    EXPECT_EQ(first.state_hash(), second.state_hash());
}

TEST(StateHash, ChangesWithEveryBitOfPlaceAndVelocity) {
    SceneDescription scene = stepped(0.004, 30.0);
    Simulation simulation(scene);
    FrameBuffer frame;
    simulation.capture(frame);
    const std::uint64_t start = simulation.state_hash();
    simulation.set_state(frame.positions, frame.velocities);
    EXPECT_EQ(simulation.state_hash(), start);
    auto x = frame.positions;
    x[7].y = std::nextafter(x[7].y, 10.0);
    simulation.set_state(x, frame.velocities);
    EXPECT_NE(simulation.state_hash(), start);
    auto v = frame.velocities;
    v[15].z = 5e-324;
    simulation.set_state(frame.positions, v);
    EXPECT_NE(simulation.state_hash(), start);
    std::swap(x = frame.positions, frame.velocities);
    simulation.set_state(frame.positions, frame.velocities);
    EXPECT_NE(simulation.state_hash(), start);
}

}  // namespace
}  // namespace weft::test
