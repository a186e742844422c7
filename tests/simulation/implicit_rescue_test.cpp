// What an implicit run does by itself where a step cannot be solved: shorter steps for the frame,
// and another linear solver for one that was chosen automatically.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "support/cloth_scenes.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

SceneDescription hanging(int size) {
    SceneDescription scene = bare_sheet(size, size);
    scene.material.structural.stiffness = 1000.0;
    scene.material.shear.stiffness = 500.0;
    scene.material.bend.stiffness = 100.0;
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.cloth.grid.plane = Plane::xz;
    const auto last = static_cast<std::size_t>(size - 1);
    scene.pins = {{ParticleSelection{{0, last}}, {}}};
    scene.integrator.method = "implicit-euler";
    scene.integrator.time_step = 1.0 / 60;
    scene.output.frames_per_second = 60.0;
    return scene;
}

// Shear springs 5e7 times softer than structural ones: more than a float tells apart.
SceneDescription badly_scaled(int size = 20) {
    SceneDescription scene = hanging(size);
    scene.material.structural.stiffness = 1e9;
    scene.material.shear.stiffness = 20.0;
    scene.material.bend.stiffness = 1.0;
    return scene;
}

// A step that takes more than the iterations allowed is made of shorter ones, which start nearer to
// their solutions; the next frame is tried with the scene's step again.
TEST(ImplicitRescue, ShortensStepsForTheFrameAlone) {
    SceneDescription scene = hanging(10);
    scene.integrator.tolerance = 1e-4;
    scene.integrator.iterations = 3;
    scene.integrator.on_divergence = OnDivergence::halve_step;
    Simulation simulation(scene);
    int halvings = 0;
    std::size_t steps = 0;
    for (int n = 0; n < 10; ++n) {
        const FrameReport report = simulation.advance_frame();
        ASSERT_TRUE(report.ok()) << report.divergence->message;
        EXPECT_EQ(report.steps, std::size_t{1} << report.halvings);
        EXPECT_DOUBLE_EQ(report.time_step, 1.0 / 60 / static_cast<double>(report.steps));
        EXPECT_EQ(simulation.steps_per_frame(), 1u);
        halvings += report.halvings;
        steps += report.steps;
    }
    EXPECT_GT(halvings, 0);
    EXPECT_EQ(simulation.step_count(), steps);
    EXPECT_NEAR(simulation.time(), 10.0 / 60, 1e-12);
}

// The same frame in as many steps from the start is the same to the bit: nothing of the attempt
// that failed is left.
TEST(ImplicitRescue, LeavesNothingOfTheAttempt) {
    for (const auto& [method, iterations] :
         {std::pair{"implicit-euler", 3}, {"bdf2", 2}, {"tr-bdf2", 2}}) {
        SceneDescription scene = hanging(10);
        scene.integrator.method = method;
        scene.integrator.tolerance = 1e-4;
        scene.integrator.iterations = iterations;
        scene.integrator.on_divergence = OnDivergence::halve_step;
        Simulation rescued(scene);
        std::vector<std::size_t> steps;
        for (int n = 0; n < 10; ++n) {
            const FrameReport report = rescued.advance_frame();
            ASSERT_TRUE(report.ok()) << method << ": " << report.divergence->message;
            steps.push_back(report.steps);
        }
        ASSERT_GT(*std::max_element(steps.begin(), steps.end()), 1u) << method;
        Simulation direct(scene);
        for (const std::size_t count : steps) {
            IntegratorDescription shorter = scene.integrator;
            shorter.time_step = 1.0 / 60 / static_cast<double>(count);
            // A frame begun anew begins without history.
            if (count > 1 || direct.steps_per_frame() != 1) direct.set_integrator(shorter);
            ASSERT_TRUE(direct.advance_frame().ok());
        }
        EXPECT_EQ(direct.state_hash(), rescued.state_hash()) << method;
    }
}

TEST(ImplicitRescue, GivesUpAfterTwelveHalvingsOrAtOnceWhereNotAsked) {
    for (const bool asked : {false, true}) {
        SceneDescription scene = hanging(6);
        if (asked) scene.integrator.on_divergence = OnDivergence::halve_step;
        Simulation simulation(scene);
        FrameBuffer frame;
        simulation.capture(frame);
        frame.velocities[29].z = std::numeric_limits<double>::quiet_NaN();
        simulation.set_state(frame.positions, frame.velocities);
        const FrameReport report = simulation.advance_frame();
        ASSERT_FALSE(report.ok());
        EXPECT_EQ(report.halvings, asked ? 12 : 0);
        EXPECT_EQ(report.divergence->step, 1u);
        EXPECT_DOUBLE_EQ(report.divergence->time_step, 1.0 / 60 / (asked ? 4096.0 : 1.0));
        EXPECT_EQ(simulation.steps_per_frame(), 1u);
    }
}

TEST(LinearSolverFallback, TakesCholeskyWhereTheAutomaticOneBreaksDown) {
    Simulation simulation(badly_scaled());
    EXPECT_EQ(simulation.linear_solver(), "multigrid");
    EXPECT_TRUE(simulation.warnings().empty());
    for (int n = 0; n < 20; ++n) {
        const FrameReport report = simulation.advance_frame();
        ASSERT_TRUE(report.ok()) << report.divergence->message;
        EXPECT_EQ(report.halvings, 0);
    }
    EXPECT_EQ(simulation.linear_solver(), "cholesky");
    ASSERT_EQ(simulation.warnings().size(), 1u);
    EXPECT_NE(simulation.warnings()[0].find("multigrid broke down"), std::string::npos);
    EXPECT_NE(simulation.warnings()[0].find("replaced by cholesky"), std::string::npos);
}

// As meshes the same sheets give their solvers no trouble, below and above a thousand particles.
TEST(LinearSolverFallback, IsNotNeededOnMeshes) {
    for (const int size : {20, 40}) {
        SceneDescription scene = badly_scaled(size);
        make_mesh_of_grid(scene);
        Simulation simulation(scene);
        for (int n = 0; n < 3; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
        EXPECT_EQ(simulation.linear_solver(), size == 20 ? "jacobi" : "aggregation");
        EXPECT_TRUE(simulation.warnings().empty());
    }
}

// It is the run that asking for cholesky gives, but that another of CHOLMOD's modules factors (and
// for what the first solver had done).
TEST(LinearSolverFallback, MovesAsCholeskyDoes) {
    SceneDescription scene = badly_scaled();
    Simulation automatic(scene);
    scene.integrator.linear_solver = LinearSolver::cholesky;
    Simulation direct(scene);
    for (int n = 0; n < 5; ++n) {
        ASSERT_TRUE(automatic.advance_frame().ok());
        ASSERT_TRUE(direct.advance_frame().ok());
    }
    FrameBuffer a, b;
    automatic.capture(a);
    direct.capture(b);
    for (std::size_t p = 0; p < a.positions.size(); ++p) {
        EXPECT_LT(length(a.positions[p] - b.positions[p]), 1e-4) << p;
    }
    EXPECT_TRUE(direct.warnings().empty());
}

TEST(LinearSolverFallback, LeavesASolverThatWasAskedForAlone) {
    SceneDescription scene = badly_scaled();
    scene.integrator.linear_solver = LinearSolver::multigrid;
    Simulation simulation(scene);
    const FrameReport report = simulation.advance_frame();
    ASSERT_FALSE(report.ok());
    EXPECT_NE(report.divergence->message.find("the linear solver did not converge"),
              std::string::npos)
        << report.divergence->message;
    EXPECT_NE(report.divergence->advice.find("cholesky"), std::string::npos);
    EXPECT_EQ(simulation.linear_solver(), "multigrid");
    EXPECT_TRUE(simulation.warnings().empty());
}

}  // namespace
}  // namespace weft::test
