// Implicit methods at a hundred times the explicit limit, for 300 frames: the shipped sheet and
// flag, and a stiff sheet of 200 x 200 (k = 1e6).
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

// One step a frame, a hundred times what velocity-verlet could take.
void expect_finite(SceneDescription scene, std::string_view method, double largest_strain) {
    scene.output.formats.clear();
    scene.integrator.method = "velocity-verlet";
    scene.integrator.time_step = 1e-6;
    const double step = 100.0 * Simulation(scene).stable_step("velocity-verlet");
    scene.integrator.method = std::string(method);
    scene.integrator.time_step = step;
    scene.output.frames_per_second = 1.0 / step;
    Simulation simulation(scene);
    EXPECT_EQ(simulation.steps_per_frame(), 1u);
    for (int n = 0; n < 300; ++n) {
        const FrameReport report = simulation.advance_frame();
        ASSERT_TRUE(report.ok()) << method << ": " << report.divergence->message;
    }
    EXPECT_LT(std::abs(simulation.largest_strain().strain), largest_strain) << method;
}

SceneDescription stiff_sheet() {
    SceneDescription scene = bare_sheet(200, 200);
    scene.material.structural.stiffness = 1e6;
    scene.material.shear.stiffness = 5e5;
    scene.material.bend.stiffness = 1e5;
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.cloth.grid.plane = Plane::xz;
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    return scene;
}

TEST(Unconditional, SheetStaysFinite) {
    for (const char* method : {"implicit-euler", "bdf2", "tr-bdf2", "sdirk2"}) {
        expect_finite(load_scene("sheet"), method, 10.0);
    }
}

TEST(Unconditional, FlagStaysFinite) {
    for (const char* method : {"implicit-euler", "tr-bdf2", "baraff-witkin"}) {
        expect_finite(load_scene("flag"), method, 1.0);
    }
}

TEST(Unconditional, StiffSheetOf40000ParticlesStaysFinite) {
    for (const char* method : {"implicit-euler", "bdf2", "sdirk2", "baraff-witkin"}) {
        expect_finite(stiff_sheet(), method, 0.1);
    }
}

}  // namespace
}  // namespace weft::test
