// Cloths that hang: the strip's stretch, the sag of a stretched sheet, both at three resolutions.
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

constexpr double density = 0.2, stiffness = 120.0, gravity = 9.81;  // [kg/m2], [N/m], [m/s2]

SceneDescription hung(int columns, int rows, double width, double height) {
    SceneDescription scene = bare_sheet(columns, rows, width, height);
    scene.material.stiffness_per = StiffnessPer::width;
    scene.material.structural.stiffness = stiffness;
    scene.material.shear.stiffness = 0.0;
    scene.material.bend.stiffness = 0.0;
    scene.forces.gravity = {0.0, -gravity, 0.0};
    return scene;
}

// At rest after so many frames, with a drag of `rate` [1/s] on an inner particle.
FrameBuffer settled(SceneDescription scene, double rate, int frames) {
    const GridShape shape = grid_shape(scene.cloth.grid);
    scene.forces.damping = rate * density * shape.dx * shape.dy;
    Simulation simulation(scene);
    for (int n = 0; n < frames; ++n) EXPECT_TRUE(simulation.advance_frame().ok());
    FrameBuffer frame;
    simulation.capture(frame);
    double speed = 0.0;
    for (const Vec3d v : frame.velocities) speed = std::max(speed, length(v));
    EXPECT_LT(speed, 1e-7);
    return frame;
}

// Under its own weight the depth y sinks by rho g (L y - y^2 / 2) / k: the end by rho g L^2 / (2
// k), 18.4 mm here. Every spring carries the weight below its middle, so the grid has it exactly.
TEST(HangingStrip, StretchesByItsWeightAtEveryResolution) {
    const double height = 1.5;
    for (const int factor : {1, 2, 4}) {
        SceneDescription scene = hung(2 * factor + 1, 5 * factor + 1, 0.3, height);
        scene.pins = {{EdgeSelection::top_edge, {}}};
        const FrameBuffer frame = settled(scene, 50.0, 110);
        const ClothModel cloth = build_cloth(scene);
        for (std::size_t p = 0; p < cloth.particle_count; ++p) {
            const double depth = -cloth.rest_position(p).y;
            const double sunk =
                density * gravity * (height * depth - depth * depth / 2) / stiffness;
            EXPECT_NEAR(-frame.positions[p].y - depth, sunk, 1e-9) << factor;
        }
        EXPECT_NEAR(-frame.positions.back().y - height,
                    density * gravity * height * height / (2 * stiffness), 1e-9);
    }
}

double middle_sag(int columns, int rows, double bend, double shear) {
    SceneDescription scene = hung(columns, rows, 1.0, 0.5);
    scene.cloth.grid.plane = Plane::xz;
    scene.material.bend.stiffness = bend;
    scene.material.shear.stiffness = shear;
    scene.pins = {{EdgeSelection::left_edge, {}}, {EdgeSelection::right_edge, {}}};
    const FrameBuffer frame = settled(scene, 12.0, 120);
    return -frame.positions[static_cast<std::size_t>((rows / 2) * columns + columns / 2)].y;
}

// Held at two edges 1 m apart, a sheet that starts flat and unstretched sags by f with
// f^3 = 3 rho g L^4 / (64 k) for small f / L: the pull rho g L^2 / (8 f) stretches it by 8/3
// (f/L)^2. Structural and bend springs lie side by side: k = 120 + 8 N/m, f = 89.6 mm.
TEST(HangingSheet, SagsAsACableAtEveryResolution) {
    const double k = stiffness + 8.0;
    const double cable = std::cbrt(3 * density * gravity / (64 * k));
    double before = 0.0;
    for (const int factor : {1, 2, 4}) {
        const double sag = middle_sag(8 * factor + 1, 4 * factor + 1, 8.0, 0.0);
        EXPECT_NEAR(sag, cable, 0.02 * cable) << factor;
        if (before > 0.0) {
            EXPECT_NEAR(sag, before, 0.01 * sag) << factor;
        }
        before = sag;
    }
}

// With shear springs the sag is smaller, 84.1, 83.7 and 83.6 mm at 1x, 2x and 4x.
TEST(HangingSheet, SagsTheSameAtEveryResolutionWithShearSprings) {
    const double one = middle_sag(9, 5, 8.0, 40.0), two = middle_sag(17, 9, 8.0, 40.0),
                 four = middle_sag(33, 17, 8.0, 40.0);
    EXPECT_NEAR(four, 0.0836, 1e-4);
    EXPECT_NEAR(two, four, 0.005 * four);
    EXPECT_NEAR(one, four, 0.015 * four);
    EXPECT_LT(std::abs(two - four), 0.6 * std::abs(one - four));
}

// With plain stiffness per spring a finer row spacing makes a softer sheet: twice the rows, twice
// the stretch. Per width it makes none.
TEST(HangingStrip, StretchesWithItsRowsWhenStiffnessIsPerSpring) {
    const auto stretch = [](int rows, StiffnessPer per) {
        SceneDescription scene = hung(3, rows, 0.6, 1.5);
        scene.material.stiffness_per = per;
        scene.pins = {{EdgeSelection::top_edge, {}}};
        return -settled(scene, 40.0, 160).positions.back().y - 1.5;
    };
    EXPECT_NEAR(stretch(11, StiffnessPer::spring) / stretch(6, StiffnessPer::spring), 2.0, 1e-4);
    EXPECT_NEAR(stretch(11, StiffnessPer::width) / stretch(6, StiffnessPer::width), 1.0, 1e-4);
}

}  // namespace
}  // namespace weft::test
