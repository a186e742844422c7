// A step allocates nothing: operator new is replaced by one that counts.
#include <gtest/gtest.h>

#include <new>

#include "counted_allocations.h"
#include "support/cloth_scenes.h"
#include "support/methods.h"
#include "weft/integrators.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

// Of the frames after the first.
long allocations_of_frames(Simulation& simulation, int frames) {
    EXPECT_TRUE(simulation.advance_frame().ok());
    bool ok = true;
    start_counting_allocations();
    for (int n = 0; n < frames; ++n) ok = simulation.advance_frame().ok() && ok;
    const long allocations = stop_counting_allocations();
    EXPECT_TRUE(ok);
    return allocations;
}

SceneDescription small_flag(bool mesh, Precision precision) {
    SceneDescription scene;
    scene.cloth.grid.resolution = {13, 9};
    scene.pins = {
        {BoxSelection{{-0.1, -9.0, -9.0}, {0.1, 9.0, 9.0}}, {{0.0, {}}, {9.0, {0.1, 0, 0}}}}};
    scene.forces.damping = 1e-4;
    scene.integrator.time_step = 1e-3;
    scene.integrator.precision = precision;
    if (mesh) make_mesh_of_grid(scene);
    return scene;
}

TEST(Allocation, IsSeenByTheCounter) {
    start_counting_allocations();
    ::operator delete(::operator new(8));  // as a call, which no compiler may leave out
    { const Vec3Array<float> array(10); }
    EXPECT_EQ(stop_counting_allocations(), 2);
}

TEST(Allocation, IsNoneInTheStepsOfAnyMethod) {
    for (const bool mesh : {false, true}) {
        for (const Precision precision : {Precision::f32, Precision::f64}) {
            for (const IntegratorInfo& info : explicit_methods()) {
                SceneDescription scene = small_flag(mesh, precision);
                scene.integrator.method = std::string(info.name);
                if (info.imaginary_limit == 0.0) scene.integrator.time_step = 5e-5;
                Simulation simulation(scene);
                EXPECT_EQ(allocations_of_frames(simulation, 5), 0) << info.name;
            }
        }
    }
}

TEST(Allocation, IsNoneWithTheEnergyBalance) {
    for (const bool mesh : {false, true}) {
        SceneDescription scene = small_flag(mesh, Precision::f32);
        scene.output.energy_balance = true;
        Simulation simulation(scene);
        EXPECT_EQ(allocations_of_frames(simulation, 5), 0);
    }
}

TEST(Allocation, IsNoneAmongObstaclesAndGrips) {
    for (const bool mesh : {false, true}) {
        for (const IntegratorInfo& info : explicit_methods()) {
            SceneDescription scene = small_flag(mesh, Precision::f32);
            scene.integrator.method = std::string(info.name);
            if (info.imaginary_limit == 0.0) scene.integrator.time_step = 5e-5;
            scene.obstacles = {{SphereObstacle{{0.7, 1.6, 0.05}, 0.2}, 0.4, 0.01},
                               {PlaneObstacle{{0.0, 1.2, 0.0}, {0.0, 1.0, 0.0}}, 0.4, 0.0}};
            Simulation simulation(scene);
            simulation.set_grips(std::vector<Grip>{{12, {1.5, 2.0, 0.2}, 30.0, 0.1}});
            EXPECT_EQ(allocations_of_frames(simulation, 5), 0) << info.name;
        }
    }
}

// The automatic step looks at the cloth every eighth frame, with two arrays; its steps take none.
TEST(Allocation, IsTwoArraysInEightFramesUnderTheAutomaticStep) {
    SceneDescription scene = small_flag(false, Precision::f32);
    scene.integrator.time_step.reset();
    Simulation simulation(scene);
    EXPECT_LE(allocations_of_frames(simulation, 16), 4);
}

}  // namespace
}  // namespace weft::test
