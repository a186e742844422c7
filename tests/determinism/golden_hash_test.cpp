// State hashes after 50 frames of a small flag in gusty wind, by the scalar twins of the kernels.
// Every build must give them, on every machine: Debug and Release, g++ and clang++. A change of
// these numbers changes every user's results: it goes with an entry tagged [RESULT] in the change
// log.
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "weft/instruction_set.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

struct Golden {
    const char* method;
    std::uint64_t single, twice;  // in float, in double
};

SceneDescription small_flag(const char* method, Precision precision) {
    SceneDescription scene;
    scene.cloth.grid.resolution = {13, 9};
    scene.material.shear.damping = 0.0;
    scene.forces.damping = 1e-5;
    scene.integrator.method = method;
    scene.integrator.precision = precision;
    scene.integrator.time_step = 4e-4;
    return scene;
}

std::uint64_t hash_after_50_frames(const SceneDescription& scene) {
    Simulation simulation(scene);
    for (int n = 0; n < 50; ++n) EXPECT_TRUE(simulation.advance_frame().ok());
    EXPECT_GT(simulation.energy().kinetic, 1e-3);  // it flies
    return simulation.state_hash();
}

class GoldenHash : public ::testing::Test {
    void SetUp() override { use_instruction_set("scalar"); }
    void TearDown() override { use_instruction_set(instruction_sets().back()); }
};

TEST_F(GoldenHash, OfEveryMethod) {
    const std::vector<Golden> golden{
        {"symplectic-euler", 0xa5541670b8ec2d04u, 0xa6b1b7df893eec12u},
        {"verlet", 0x29e58e95323ef5b5u, 0xca50da55a95feef8u},
        {"velocity-verlet", 0x474c2d15d434a425u, 0x6cd8ac01898c6296u},
        {"rk3", 0xa59e77bb36c72cc1u, 0x20b1c1398c5eac47u},
        {"rk4", 0xb30a343eeff5594bu, 0x8952ad1bc1c51fb1u},
        {"yoshida4", 0xa5698fab9215f48au, 0xf517af192fd0d7c2u},
    };
    for (const auto& [method, single, twice] : golden) {
        EXPECT_EQ(hash_after_50_frames(small_flag(method, Precision::f32)), single) << method;
        EXPECT_EQ(hash_after_50_frames(small_flag(method, Precision::f64)), twice) << method;
    }
}

TEST_F(GoldenHash, OfAMeshWithTheAutomaticStepAndMovingPins) {
    SceneDescription scene = small_flag("velocity-verlet", Precision::f32);
    make_mesh_of_grid(scene);
    scene.integrator.time_step.reset();
    scene.pins = {{ParticleSelection{{0, 13, 26}}, {{0.0, {}}, {1.0, {0.1, 0.0, 0.2}}}}};
    EXPECT_EQ(hash_after_50_frames(scene), 0xfa48ee5c92fc62feu);
}

}  // namespace
}  // namespace weft::test
