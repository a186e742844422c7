// A plate that falls in still air ends at sqrt(2 sigma g / (rho C_N)), C_N = 1 / (0.222 + 0.283)
// = 1.98.
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

SceneDescription falling_plate(double mass_per_area) {
    SceneDescription scene = bare_sheet(6, 6);
    scene.cloth.grid.plane = Plane::xz;
    scene.material.mass_per_area = mass_per_area;
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.wind = WindDescription{};
    scene.wind->velocity = {0.0, 0.0, 0.0};
    scene.wind->air_density = 1.225;
    return scene;
}

double terminal_speed(double mass_per_area) {
    return std::sqrt(2 * mass_per_area * 9.81 * (0.222 + 0.283) / 1.225);
}

// On a mesh each particle carries its triangles' mass and air in equal parts, so the plate stays
// flat.
TEST(FallingPlate, EndsAtItsTerminalSpeed) {
    for (const double sigma : {0.05, 0.2, 1.0}) {
        SceneDescription scene = falling_plate(sigma);
        make_mesh_of_grid(scene);
        Simulation simulation(scene);
        FrameBuffer frame;
        for (int n = 0; n < 90; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
        simulation.capture(frame);
        const double speed = terminal_speed(sigma);
        for (const Vec3d v : frame.velocities) EXPECT_NEAR(-v.y, speed, 1e-6 * speed) << sigma;
        EXPECT_LT(std::abs(simulation.largest_strain().strain), 1e-9);
    }
    EXPECT_NEAR(terminal_speed(0.2), 1.27, 0.005);
}

// v = V tanh(g t / V) on the way there.
TEST(FallingPlate, GathersSpeedAsAHyperbolicTangent) {
    SceneDescription scene = falling_plate(0.2);
    scene.integrator.time_step = 5e-4;
    make_mesh_of_grid(scene);
    Simulation simulation(scene);
    FrameBuffer frame;
    const double speed = terminal_speed(0.2);
    for (int n = 1; n <= 15; ++n) {
        ASSERT_TRUE(simulation.advance_frame().ok());
        simulation.capture(frame);
        EXPECT_NEAR(-frame.velocities[14].y, speed * std::tanh(9.81 * n / 30.0 / speed),
                    1e-5 * speed);
    }
}

}  // namespace
}  // namespace weft::test
