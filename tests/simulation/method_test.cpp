// The automatic method, changing the method in the middle of a run, and implicit runs that fail.
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "support/methods.h"
#include "weft/error.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

SceneDescription curtain(int columns, int rows, double stiffness) {
    SceneDescription scene = bare_sheet(columns, rows);
    scene.material.structural.stiffness = stiffness;
    scene.material.shear.stiffness = stiffness / 2;
    scene.material.bend.stiffness = stiffness / 10;
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.cloth.grid.plane = Plane::xz;
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    scene.integrator.method = "auto";
    scene.output.frames_per_second = 60.0;
    return scene;
}

TEST(AutomaticMethod, IsExplicitForSoftClothAndImplicitForStiff) {
    const Simulation soft(curtain(20, 20, 100.0)), stiff(curtain(40, 40, 1e8));
    EXPECT_EQ(soft.method(), "velocity-verlet");
    EXPECT_EQ(stiff.method(), "tr-bdf2");
    EXPECT_NE(soft.method_reason().find("cost less than"), std::string::npos);
    EXPECT_NE(stiff.method_reason().find("cost more than"), std::string::npos);
    EXPECT_NE(stiff.method_reason().find("1600 particles"), std::string::npos);
    EXPECT_EQ(stiff.linear_solver(), "multigrid");
    EXPECT_EQ(soft.linear_solver(), "");
}

TEST(AutomaticMethod, SuitsTheStepThatIsGiven) {
    SceneDescription scene = curtain(20, 20, 100.0);
    const double limit = Simulation(scene).stable_step("velocity-verlet");
    scene.integrator.time_step = 0.9 * limit;
    EXPECT_EQ(Simulation(scene).method(), "velocity-verlet");
    scene.integrator.time_step = 1.1 * limit;
    const Simulation implicit(scene);
    EXPECT_EQ(implicit.method(), "tr-bdf2");
    EXPECT_NE(implicit.method_reason().find("beyond the explicit limit"), std::string::npos);
}

TEST(AutomaticMethod, HasNoReasonWhereTheSceneNamesIt) {
    SceneDescription scene = curtain(10, 10, 100.0);
    scene.integrator.method = "rk4";
    const Simulation simulation(scene);
    EXPECT_EQ(simulation.method(), "rk4");
    EXPECT_EQ(simulation.method_reason(), "");
}

TEST(EveryMethod, LeavesParticlesThatNothingMoves) {
    for (const IntegratorInfo& info : integrator_catalogue()) {
        SceneDescription scene = bare_sheet(5, 5);
        scene.material.structural = scene.material.shear = scene.material.bend = {0.0, 0.0};
        scene.integrator.method = std::string(info.name);
        scene.integrator.time_step = 1e-3;
        Simulation simulation(scene);
        const std::uint64_t start = simulation.state_hash();
        const FrameReport report = simulation.advance_frame();
        EXPECT_TRUE(report.ok()) << report.divergence->message;
        EXPECT_EQ(simulation.state_hash(), start) << info.name;
    }
}

// Contact acts between steps (docs/contact.md).
TEST(AutomaticMethod, AmongObstaclesIsOfOneStageAndItsStepsShort) {
    SceneDescription scene = curtain(40, 40, 1e8);
    scene.obstacles = {ObstacleDescription{}};
    const Simulation stiff(scene);
    EXPECT_EQ(stiff.method(), "implicit-euler");
    EXPECT_DOUBLE_EQ(stiff.time_step(), 1.0 / 240);
    for (const IntegratorInfo& info : integrator_catalogue()) {
        scene = curtain(6, 6, 100.0);
        scene.obstacles = {ObstacleDescription{}};
        scene.integrator.method = std::string(info.name);
        if (info.imaginary_limit == 0.0) continue;
        const bool one_stage = info.kind == IntegratorKind::implicit && info.order == 1;
        EXPECT_LE(Simulation(scene).time_step(), (one_stage ? 1.0 / 240 : 1.0 / 480) + 1e-12)
            << info.name;
    }
}

// One step a frame for those that choose their own, the catalogue's for those without a limit.
TEST(AutomaticStep, IsTheMethodsOwn) {
    for (const IntegratorInfo& info : integrator_catalogue()) {
        SceneDescription scene = curtain(6, 6, 100.0);
        scene.integrator.method = std::string(info.name);
        if (info.imaginary_limit == 0.0) scene.integrator.time_step = 1e-4;
        const Simulation simulation(scene);
        if (info.kind == IntegratorKind::adaptive) {
            EXPECT_EQ(simulation.steps_per_frame(), 1u) << info.name;
        } else if (info.auto_step > 0.0) {
            EXPECT_NEAR(simulation.time_step(), std::min(info.auto_step, 1.0 / 60), 1e-12)
                << info.name;
        }
    }
}

// Every method, at a hundred times the explicit limit where it knows none.
TEST(ImplicitRuns, StayFiniteAtAHundredTimesTheExplicitLimit) {
    for (const bool mesh : {false, true}) {
        for (const IntegratorInfo& info : methods_of({IntegratorKind::implicit})) {
            SceneDescription scene = curtain(10, 10, 3e4);
            if (mesh) {
                make_mesh_of_grid(scene);
                scene.pins = {{ParticleSelection{{0, 9}}, {}}};
            }
            const double limit = Simulation(scene).stable_step("velocity-verlet");
            scene.integrator.method = std::string(info.name);
            scene.integrator.time_step = 100.0 * limit;
            Simulation simulation(scene);
            for (int n = 0; n < 60; ++n) {
                const FrameReport report = simulation.advance_frame();
                ASSERT_TRUE(report.ok()) << info.name << ": " << report.divergence->message;
            }
            // Those that do not damp what they cannot resolve let it ring, and may gain energy.
            const bool damps = amplification(info.name, 1e6, 0.0) < 0.5;
            EXPECT_LT(std::abs(simulation.largest_strain().strain), damps ? 1.0 : 100.0)
                << info.name;
            EXPECT_GE(simulation.solver_counts().newton_iterations, 60u) << info.name;
        }
    }
}

// The same motion by every method, whatever its steps: a short swing, in double.
TEST(ImplicitRuns, AgreeWithTheExplicitMotion) {
    const auto end_of = [](std::string_view method, double step) {
        SceneDescription scene = curtain(8, 8, 200.0);
        scene.integrator.method = std::string(method);
        scene.integrator.time_step = step;
        scene.integrator.tolerance = 1e-9;
        Simulation simulation(scene);
        for (int n = 0; n < 12; ++n) EXPECT_TRUE(simulation.advance_frame().ok()) << method;
        FrameBuffer frame;
        simulation.capture(frame);
        return frame.positions;
    };
    const auto reference = end_of("rk4", 2e-5);
    for (const IntegratorInfo& info :
         methods_of({IntegratorKind::implicit, IntegratorKind::adaptive})) {
        const auto positions = end_of(info.name, info.order == 1 ? 2.5e-5 : 2e-4);
        double off = 0.0;
        for (std::size_t p = 0; p < positions.size(); ++p) {
            off = std::max(off, length(positions[p] - reference[p]));
        }
        EXPECT_LT(off, info.order == 1 ? 3e-4 : 2e-5) << info.name;
    }
}

TEST(ChangingTheMethod, KeepsTheStateAndTheTime) {
    SceneDescription scene = curtain(12, 12, 300.0);
    Simulation simulation(scene);
    for (int n = 0; n < 3; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
    const std::uint64_t hash = simulation.state_hash();
    for (const char* method : {"implicit-euler", "dopri5", "vbd", "rk4", "bdf2", "auto"}) {
        IntegratorDescription other = scene.integrator;
        other.method = method;
        simulation.set_integrator(other);
        EXPECT_EQ(simulation.state_hash(), hash) << method;
        EXPECT_EQ(simulation.frame(), 3u);
        EXPECT_EQ(simulation.time(), 0.05);
        EXPECT_EQ(simulation.scene().integrator.method, method);
    }
    IntegratorDescription implicit = scene.integrator;
    implicit.method = "tr-bdf2";
    simulation.set_integrator(implicit);
    for (int n = 0; n < 3; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
    const std::size_t iterations = simulation.solver_counts().newton_iterations;
    EXPECT_GT(iterations, 0u);
    simulation.set_integrator(scene.integrator);  // back: what was counted stays
    ASSERT_TRUE(simulation.advance_frame().ok());
    EXPECT_EQ(simulation.solver_counts().newton_iterations, iterations);
    EXPECT_EQ(simulation.frame(), 7u);
}

TEST(ChangingTheMethod, ThatIsRefusedChangesNothing) {
    SceneDescription scene = curtain(8, 8, 300.0);
    scene.integrator.method = "velocity-verlet";
    Simulation simulation(scene);
    const auto refused = [&](const IntegratorDescription& other, const std::string& key) {
        try {
            simulation.set_integrator(other);
            ADD_FAILURE() << key << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.place().key, key);
        }
        EXPECT_EQ(simulation.method(), "velocity-verlet");
        EXPECT_EQ(simulation.scene().integrator.method, "velocity-verlet");
    };
    IntegratorDescription other = scene.integrator;
    other.method = "rk5";
    refused(other, "integrator.method");
    other = scene.integrator;
    other.precision = Precision::f32;
    refused(other, "integrator.precision");
    other = scene.integrator;
    other.method = "forward-euler";  // stable at no step on this undamped cloth
    refused(other, "integrator.time_step");
    ASSERT_TRUE(simulation.advance_frame().ok());
}

// A step that Newton cannot solve, nor any of a 64th of it, ends the run as a divergence does, with
// the last good state ...
TEST(ImplicitFailures, EndTheRunAtTheLastGoodFrame) {
    SceneDescription scene = curtain(10, 10, 1e5);
    scene.integrator.method = "implicit-euler";
    scene.integrator.time_step = 1.0 / 60;
    scene.integrator.tolerance = 1e-6;
    Simulation simulation(scene);
    ASSERT_TRUE(simulation.advance_frame().ok());
    IntegratorDescription starved = scene.integrator;
    starved.iterations = 1;
    starved.tolerance = 1e-12;
    simulation.set_integrator(starved);
    const std::uint64_t hash = simulation.state_hash();
    const FrameReport report = simulation.advance_frame();
    ASSERT_FALSE(report.ok());
    EXPECT_NE(report.divergence->message.find("implicit-euler cannot make step 2"),
              std::string::npos)
        << report.divergence->message;
    EXPECT_NE(report.divergence->message.find("after 1 iterations"), std::string::npos);
    EXPECT_NE(report.divergence->advice.find("integrator.iterations"), std::string::npos);
    EXPECT_EQ(simulation.state_hash(), hash);
    EXPECT_EQ(simulation.frame(), 1u);
}

// ... and follows on_divergence: shorter steps start nearer to their solution.
TEST(ImplicitFailures, HalveTheStepWhereTheSceneSaysSo) {
    SceneDescription scene = curtain(10, 10, 1e3);
    scene.integrator.method = "implicit-euler";
    scene.integrator.time_step = 1.0 / 60;
    scene.integrator.tolerance = 1e-4;
    scene.integrator.iterations = 3;
    scene.integrator.on_divergence = OnDivergence::halve_step;
    Simulation simulation(scene);
    int halvings = 0;
    for (int n = 0; n < 10; ++n) {
        const FrameReport report = simulation.advance_frame();
        ASSERT_TRUE(report.ok()) << report.divergence->message;
        halvings += report.halvings;
    }
    EXPECT_GT(halvings, 0);
}

}  // namespace
}  // namespace weft::test
