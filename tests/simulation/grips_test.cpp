// Grips: springs from particles to points of space, stable at any stiffness and step.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/cloth_scenes.h"
#include "support/methods.h"
#include "support/scene_errors.h"
#include "support/test_name.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

SceneDescription sheet(const std::string& method) {
    SceneDescription scene = bare_sheet(8, 8, 0.5, 0.5);
    add_dashpots(scene, 1e-3);
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.integrator.method = method;
    if (find_integrator(method)->imaginary_limit == 0.0) scene.integrator.time_step = 2e-4;
    return scene;
}

std::vector<Grip> both_corners(double stiffness, double damping) {
    return {{0, {0.0, 0.0, 0.0}, stiffness, damping}, {7, {0.5, 0.0, 0.0}, stiffness, damping}};
}

void fly(Simulation& simulation, int frames) {
    for (int n = 0; n < frames; ++n) {
        const FrameReport report = simulation.advance_frame();
        ASSERT_TRUE(report.ok()) << report.divergence->message;
    }
}

// Particles without springs, each by a grip of its own: x = p + m g / k.
TEST(Grips, HoldAParticleWhereTheSpringBearsItsWeight) {
    for (const IntegratorInfo& info : integrator_catalogue()) {
        SceneDescription scene = sheet(std::string(info.name));
        scene.material.structural = scene.material.shear = scene.material.bend = {0.0, 0.0};
        scene.material.particle_mass = 0.02;
        scene.integrator.time_step = 1e-3;
        if (info.imaginary_limit == 0.0) scene.integrator.time_step = 1e-4;
        Simulation simulation(scene);
        std::vector<Grip> grips;
        const Vec3d point{0.1, 0.2, 0.3};
        for (std::size_t p = 0; p < 64; ++p) grips.push_back({p, point, 5.0, 0.3});
        simulation.set_grips(grips);
        fly(simulation, 100);  // 3.3 s: 25 times the time of damping 2 m / c
        FrameBuffer frame;
        simulation.capture(frame);
        const double offset = 0.02 * 9.81 / 5.0;  // 39 mm
        for (const Vec3d& x : frame.positions) {
            ASSERT_LT(length(x - point + Vec3d{0.0, offset, 0.0}), 2e-4) << info.name;
        }
        EXPECT_NEAR(simulation.grip_force().y, 64 * 0.02 * 9.81, 0.01) << info.name;
    }
}

// The springs' sums round differently, and iterative solvers, which stop where they are near enough
// (at 35 um here), answer that by more; a spring too much would be seen in centimetres.
TEST(Grips, OfOneParticleAct) {
    SceneDescription scene = sheet("implicit-euler");
    Simulation one(scene), several(scene);
    one.set_grips(std::vector<Grip>{{3, {0.1, 0.0, 0.2}, 30.0, 0.3}});
    several.set_grips(
        std::vector<Grip>{{3, {0.4, 0.0, 0.2}, 10.0, 0.1}, {3, {-0.05, 0.0, 0.2}, 20.0, 0.2}});
    fly(one, 10);
    fly(several, 10);
    FrameBuffer a, b;
    one.capture(a);
    several.capture(b);
    for (std::size_t p = 0; p < a.positions.size(); ++p) {
        ASSERT_LT(length(a.positions[p] - b.positions[p]), 1e-6);
    }
}

class GripMethods : public testing::TestWithParam<std::string> {};

TEST_P(GripMethods, StayStableFromSoftToHardAtEveryStep) {
    for (const double stiffness : {1.0, 1e3, 1e6, 1e9}) {
        for (const double damping : {0.0, 1.0}) {
            const SceneDescription scene = sheet(GetParam());
            Simulation simulation(scene);
            const double start = simulation.energy().total();
            simulation.set_grips(both_corners(stiffness, damping));
            fly(simulation, 90);
            EXPECT_LT(std::abs(simulation.largest_strain().strain), 3.0) << stiffness;
            EXPECT_LT(simulation.energy().kinetic, 2.0) << stiffness;
            EXPECT_LT(simulation.energy().total() - start, 0.05) << stiffness;
            FrameBuffer frame;
            simulation.capture(frame);
            EXPECT_LT(length(frame.positions[0]), stiffness >= 1e3 ? 0.05 : 1.0) << stiffness;
        }
    }
}

TEST_P(GripMethods, HoldTheWholeClothByTwoCorners) {
    SceneDescription scene = sheet(GetParam());
    scene.forces.damping = 2e-3;
    Simulation simulation(scene);
    simulation.set_grips(both_corners(200.0, 0.2));
    fly(simulation, 240);
    const double weight = simulation.total_mass() * 9.81;
    EXPECT_NEAR(simulation.grip_force().y, weight, 0.05 * weight);
    FrameBuffer frame;
    simulation.capture(frame);
    EXPECT_NEAR(frame.positions[0].y, -weight / 2 / 200.0, 2e-3);
    simulation.set_grips({});
    EXPECT_EQ(simulation.grip_force(), Vec3d{});
    fly(simulation, 3);
    simulation.capture(frame);
    EXPECT_LT(frame.positions[0].y, -0.02);
}

INSTANTIATE_TEST_SUITE_P(Methods, GripMethods,
                         testing::Values("symplectic-euler", "velocity-verlet", "verlet", "rk4",
                                         "yoshida4", "dopri5", "implicit-euler", "tr-bdf2", "bdf2",
                                         "baraff-witkin", "xpbd", "vbd", "projective-dynamics"),
                         test_name);

TEST(Grips, ThatAreNoneLeaveEveryBit) {
    for (const char* method : {"velocity-verlet", "verlet", "dopri5", "bdf2", "tr-bdf2", "vbd"}) {
        Simulation never(sheet(method)), none(sheet(method));
        none.set_grips({});
        fly(never, 3);
        fly(none, 1);
        none.set_grips({});
        fly(none, 2);
        EXPECT_EQ(never.state_hash(), none.state_hash()) << method;
    }
}

TEST(Grips, DoNotMovePins) {
    for (const char* method : {"velocity-verlet", "tr-bdf2"}) {
        SceneDescription scene = sheet(method);
        scene.pins = {{EdgeSelection::top_left, {}}};
        Simulation with(scene), without(scene);
        with.set_grips(std::vector<Grip>{{0, {5.0, 5.0, 5.0}, 1e3, 1.0}});
        EXPECT_EQ(with.grip_force(), Vec3d{});
        without.set_grips({});
        fly(with, 3);
        fly(without, 3);
        EXPECT_EQ(with.state_hash(), without.state_hash());
    }
}

TEST(Grips, GiveTheSameBitsOnAnyNumberOfThreads) {
    for (const char* method : {"velocity-verlet", "implicit-euler"}) {
        SceneDescription scene = sheet(method);
        scene.cloth.grid.resolution = {200, 150};
        scene.integrator.time_step = method == std::string("implicit-euler") ? 1.0 / 240 : 1e-3;
        scene.material.particle_mass = 1e-3;
        scene.obstacles = {{SphereObstacle{{0.25, -0.2, 0.0}, 0.1}, 0.3, 0.002}};
        std::uint64_t hash = 0;
        for (const int threads : {1, 3}) {
            Simulation simulation(scene, threads);
            simulation.set_grips(both_corners(100.0, 0.1));
            fly(simulation, 3);
            if (threads == 1) hash = simulation.state_hash();
            EXPECT_EQ(simulation.state_hash(), hash) << method;
        }
    }
}

TEST(Grips, ThatCannotBeAreRefusedAndChangeNothing) {
    Simulation simulation(sheet("velocity-verlet"));
    simulation.set_grips(both_corners(10.0, 0.1));
    const Vec3d force = simulation.grip_force();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refusal = [&](const Grip& grip) {
        const std::vector<Grip> grips{{0, {}, 1.0, 0.0}, grip};
        const auto error = error_of([&] { simulation.set_grips(grips); });
        EXPECT_EQ(simulation.grip_force(), force);
        return error && error->kind() == ErrorKind::usage ? error->place().key : "";
    };
    EXPECT_EQ(refusal({64, {}, 1.0, 0.0}), "grips[1].particle");
    EXPECT_EQ(refusal({1, {nan, 0.0, 0.0}, 1.0, 0.0}), "grips[1].point");
    EXPECT_EQ(refusal({1, {}, -1.0, 0.0}), "grips[1].stiffness");
    EXPECT_EQ(refusal({1, {}, nan, 0.0}), "grips[1].stiffness");
    EXPECT_EQ(refusal({1, {}, 1.0, -1e-9}), "grips[1].damping");
}

}  // namespace
}  // namespace weft::test
