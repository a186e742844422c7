// The change of energy equals the work of dashpots, drag, air and pins; what remains is the
// methods' error, of second order in the step.
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

SceneDescription windy_flag() {
    SceneDescription scene;
    scene.cloth.grid.resolution = {13, 9};
    scene.forces.damping = 1e-4;
    scene.integrator.precision = Precision::f64;
    scene.output.energy_balance = true;
    return scene;
}

SceneDescription moved_curtain() {
    SceneDescription scene = bare_sheet(10, 8);
    scene.forces = {{0.0, -9.81, 0.0}, 2e-3};
    add_dashpots(scene, 2e-3);
    scene.pins = {{EverySelection{3, EdgeSelection::top_edge},
                   {{0.0, {}}, {0.7, {-0.3, 0.0, 0.2}}, {2.0, {0.1, 0.2, 0.0}}}}};
    scene.output.energy_balance = true;
    return scene;
}

struct Balance {
    double residual = 0.0;  ///< change of energy less work [J]
    Work work;
    double moved = 0.0;  ///< largest energy exchanged by one cause [J]
};

Balance balance_of(SceneDescription scene, const char* method, double time_step) {
    scene.integrator.method = method;
    scene.integrator.time_step = time_step;
    Simulation simulation(scene);
    const double start = simulation.energy().total();
    for (int n = 0; n < 15; ++n) EXPECT_TRUE(simulation.advance_frame().ok()) << method;
    const Work work = simulation.work();
    const double change = simulation.energy().total() - start;
    return {change - work.total(), work,
            std::max({std::abs(work.dashpots), std::abs(work.drag), std::abs(work.air),
                      std::abs(work.pins)})};
}

constexpr std::array methods{
    "velocity-verlet", "verlet", "time-corrected-verlet", "rk2", "rk3", "rk4"};

void expect_balance(const SceneDescription& scene, double time_step) {
    for (const char* method : methods) {
        const Balance coarse = balance_of(scene, method, time_step);
        const Balance fine = balance_of(scene, method, time_step / 2);
        EXPECT_LT(std::abs(coarse.residual), 5e-3 * coarse.moved) << method;
        // A quarter; but a residual that happens to pass through zero has nothing to shrink from.
        EXPECT_LT(std::abs(fine.residual),
                  0.4 * std::max(std::abs(coarse.residual), 5e-4 * coarse.moved))
            << method;
        EXPECT_LT(coarse.work.dashpots, 0.0) << method;
        EXPECT_LT(coarse.work.drag, 0.0) << method;
    }
}

TEST(EnergyBalance, OfAFlagInTheWindCloses) {
    expect_balance(windy_flag(), 2e-4);
    const Work work = balance_of(windy_flag(), "velocity-verlet", 2e-4).work;
    EXPECT_GT(work.air, 0.01);
    EXPECT_EQ(work.pins, 0.0);
}

TEST(EnergyBalance, OfAMeshInTheWindCloses) {
    SceneDescription scene = windy_flag();
    make_mesh_of_grid(scene);
    scene.pins = {{BoxSelection{{-0.1, -9.0, -9.0}, {0.1, 9.0, 9.0}}, {}}};
    const Balance coarse = balance_of(scene, "velocity-verlet", 2e-4);
    const Balance fine = balance_of(scene, "velocity-verlet", 1e-4);
    EXPECT_LT(std::abs(coarse.residual), 5e-3 * coarse.moved);
    EXPECT_LT(std::abs(fine.residual), 0.4 * std::abs(coarse.residual));
}

TEST(EnergyBalance, OfACurtainOnMovingPinsCloses) {
    expect_balance(moved_curtain(), 1e-3);
    const Work work = balance_of(moved_curtain(), "velocity-verlet", 1e-3).work;
    EXPECT_GT(std::abs(work.pins), 0.01);
    EXPECT_EQ(work.air, 0.0);
}

// Moving pins in the wind: the air's work on pinned particles comes from the pins.
TEST(EnergyBalance, OfMovingPinsInTheWindCloses) {
    SceneDescription scene = moved_curtain();
    scene.wind = WindDescription{};
    const Balance coarse = balance_of(scene, "velocity-verlet", 4e-4);
    const Balance fine = balance_of(scene, "velocity-verlet", 2e-4);
    EXPECT_LT(std::abs(coarse.residual), 5e-3 * coarse.moved);
    EXPECT_LT(std::abs(fine.residual), 0.4 * std::abs(coarse.residual));
    EXPECT_GT(std::abs(coarse.work.air), 0.01);
    EXPECT_GT(std::abs(coarse.work.pins), 0.01);
}

TEST(EnergyBalance, IsKeptOnlyWhenAsked) {
    SceneDescription scene = moved_curtain();
    scene.output.energy_balance = false;
    EXPECT_EQ(balance_of(scene, "rk4", 1e-3).work.total(), 0.0);
}

// Weighing the cloth by hand: without damping or air, pins that lift it slowly do its weight's
// work.
TEST(EnergyBalance, OfALiftIsWeightTimesHeight) {
    SceneDescription scene = bare_sheet(5, 5);
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.pins = {{EdgeSelection::top_edge, {{0.0, {}}, {1.0, {0.0, 2.0, 0.0}}}}};
    scene.output.energy_balance = true;
    scene.integrator.time_step = 2e-4;
    Simulation simulation(scene);
    const double start = simulation.energy().total();
    for (int n = 0; n < 36; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
    const double work = simulation.work().pins;
    EXPECT_NEAR(simulation.energy().total() - start, work, 1e-4 * work);
    EXPECT_NEAR(work, 0.2 * 9.81 * 2.0, 0.15 * work);  // and what still swings
}

}  // namespace
}  // namespace weft::test
