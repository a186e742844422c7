// Static equilibrium by settling: closed forms of strips, cables and chains, and what cannot rest.
#include <gtest/gtest.h>

#include <cmath>

#include "support/cloth_scenes.h"
#include "weft/error.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

constexpr double density = 0.2, stiffness = 120.0, gravity = 9.81;  // [kg/m2], [N/m], [m/s2]

SceneDescription hung(int columns, int rows, double width, double height) {
    SceneDescription scene = bare_sheet(columns, rows, width, height);
    scene.material.stiffness_per = StiffnessPer::width;
    scene.material.structural.stiffness = stiffness;
    scene.material.shear.stiffness = 40.0;
    scene.material.bend.stiffness = 0.0;
    scene.forces.gravity = {0.0, -gravity, 0.0};
    scene.output.settle = true;
    return scene;
}

FrameBuffer first_frame(const SceneDescription& scene) {
    const Simulation simulation(scene);
    EXPECT_TRUE(simulation.settle_report()->converged);
    EXPECT_LE(simulation.settle_report()->relative_residual, 1e-6);
    FrameBuffer frame;
    simulation.capture(frame);
    for (const Vec3d v : frame.velocities) EXPECT_EQ(v, Vec3d{});
    return frame;
}

// The strip of hanging_test.cpp, found without running it: rho g L^2 / (2 k). A mesh of quads gives
// its corners other shares of the mass, and so 2 % more to this end.
TEST(Settle, HangsAStripAtItsClosedForm) {
    for (const bool mesh : {false, true}) {
        SceneDescription scene = hung(3, 16, 0.3, 1.5);
        scene.material.shear.stiffness = 0.0;
        scene.pins = {{EdgeSelection::top_edge, {}}};
        if (mesh) {
            make_mesh_of_grid(scene);
            scene.pins = {{ParticleSelection{{0, 1, 2}}, {}}};
        }
        const double end = -first_frame(scene).positions.back().y;
        const double stretch = density * gravity * 1.5 * 1.5 / (2 * stiffness);
        EXPECT_NEAR(end - 1.5, stretch, mesh ? 0.03 * stretch : 1e-7);
    }
}

// The sheet of hanging_test.cpp between two edges, 84.1, 83.7, 83.6 mm: from flat, where nothing
// resists its first move.
TEST(Settle, SagsAFlatSheetAsRunningItDoes) {
    const auto sag = [](int columns, int rows) {
        SceneDescription scene = hung(columns, rows, 1.0, 0.5);
        scene.cloth.grid.plane = Plane::xz;
        scene.material.bend.stiffness = 8.0;
        scene.pins = {{EdgeSelection::left_edge, {}}, {EdgeSelection::right_edge, {}}};
        const FrameBuffer frame = first_frame(scene);
        return -frame.positions[static_cast<std::size_t>((rows / 2) * columns + columns / 2)].y;
    };
    EXPECT_NEAR(sag(9, 5), 0.0841, 1e-4);
    EXPECT_NEAR(sag(17, 9), 0.0837, 1e-4);
    EXPECT_NEAR(sag(33, 17), 0.0836, 1e-4);
}

// A narrow stiff strip hung from its ends nearer to each other than its length: a catenary of
// length S over span D sags by a (cosh(D / 2a) - 1), where 2 a sinh(D / 2a) = S.
TEST(Settle, FindsTheCatenary) {
    SceneDescription scene = hung(101, 2, 1.2, 0.02);
    scene.cloth.grid.plane = Plane::xz;
    scene.material.structural.stiffness = 5e3;
    scene.material.shear.stiffness = 5e2;
    const double span = 1.0, length = 1.2;
    // The right edge is drawn in before the cloth is let go.
    scene.pins = {{EdgeSelection::left_edge, {}},
                  {EdgeSelection::right_edge, {{0.0, {span - length, 0.0, 0.0}}}}};
    double a = 0.3;
    for (int n = 0; n < 100; ++n) {  // Newton for 2 a sinh(D / 2a) - S
        const double u = span / (2 * a);
        a -= (2 * a * std::sinh(u) - length) / (2 * std::sinh(u) - 2 * u * std::cosh(u));
    }
    const double expected = a * (std::cosh(span / (2 * a)) - 1);
    const FrameBuffer frame = first_frame(scene);
    double lowest = 0.0;
    for (const Vec3d x : frame.positions) lowest = std::min(lowest, x.y);
    EXPECT_NEAR(-lowest, expected, 2e-3 * expected);
}

// Two pinned corners: buckles and folds, and still comes to rest; the same by every solver.
TEST(Settle, DrapesASheetFromTwoCorners) {
    double before = 0.0;
    for (const LinearSolver solver : {LinearSolver::multigrid, LinearSolver::cholesky}) {
        SceneDescription scene = hung(25, 25, 1.0, 1.0);
        scene.material.bend.stiffness = 5.0;
        scene.integrator.linear_solver = solver;
        scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
        const FrameBuffer frame = first_frame(scene);
        const double low = frame.positions[24 * 25 + 12].y;
        EXPECT_LT(low, -1.0);
        if (before != 0.0) {
            EXPECT_NEAR(low, before, 1e-3);
        }
        before = low;
    }
}

// From a state in motion, through the library; the run goes on from rest.
TEST(Settle, StopsARunningClothWhereItHangs) {
    SceneDescription scene = hung(9, 9, 1.0, 1.0);
    scene.output.settle = false;
    scene.cloth.grid.plane = Plane::xz;
    scene.pins = {{EdgeSelection::left_edge, {}}, {EdgeSelection::right_edge, {}}};
    Simulation simulation(scene);
    EXPECT_FALSE(simulation.settle_report().has_value());
    for (int n = 0; n < 5; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
    EXPECT_GT(simulation.energy().kinetic, 1e-3);
    const SettleReport report = simulation.settle();
    EXPECT_TRUE(report.converged) << report.message;
    EXPECT_GT(report.newton_iterations, 0u);
    EXPECT_EQ(simulation.energy().kinetic, 0.0);
    EXPECT_EQ(simulation.frame(), 5u);
    const double rest = simulation.energy().total();
    for (int n = 0; n < 30; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
    EXPECT_LT(simulation.energy().kinetic, 1e-9);
    EXPECT_NEAR(simulation.energy().total(), rest, 1e-7);
}

TEST(Settle, RefusesAClothThatNothingHolds) {
    SceneDescription scene = hung(5, 5, 1.0, 1.0);
    try {
        Simulation simulation(scene);
        FAIL() << "settled in free fall";
    } catch (const Error& error) {
        EXPECT_EQ(error.place().key, "output.settle");
        EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
}

}  // namespace
}  // namespace weft::test
