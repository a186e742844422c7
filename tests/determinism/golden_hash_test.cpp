// State hashes after 50 frames of a small flag in gusty wind. Every build must give them: Debug and
// Release, g++ and clang++. A change of these numbers changes every user's results: it goes with an
// entry tagged [RESULT] in the change log.
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
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

TEST(GoldenHash, OfEveryMethod) {
    const std::vector<Golden> golden{
        {"symplectic-euler", 0x03aad7b2e527fe69u, 0x8c09faf9ae227cc4u},
        {"verlet", 0xf859e5eae05076d9u, 0x67296f45cb29bf91u},
        {"velocity-verlet", 0xf1dc1e8aef5019fcu, 0x3c480ba8988b64f1u},
        {"rk3", 0x8d5038129a722280u, 0x8d4450b0f433250du},
        {"rk4", 0x11440850c01507cfu, 0x7ea6c966dd32477bu},
        {"yoshida4", 0xbdd04c813fcb329du, 0x53323273670dfa6bu},
    };
    for (const auto& [method, single, twice] : golden) {
        EXPECT_EQ(hash_after_50_frames(small_flag(method, Precision::f32)), single) << method;
        EXPECT_EQ(hash_after_50_frames(small_flag(method, Precision::f64)), twice) << method;
    }
}

TEST(GoldenHash, OfAMeshWithTheAutomaticStepAndMovingPins) {
    SceneDescription scene = small_flag("velocity-verlet", Precision::f32);
    make_mesh_of_grid(scene);
    scene.integrator.time_step.reset();
    scene.pins = {{ParticleSelection{{0, 13, 26}}, {{0.0, {}}, {1.0, {0.1, 0.0, 0.2}}}}};
    EXPECT_EQ(hash_after_50_frames(scene), 0x61292f647215c4c2u);
}

}  // namespace
}  // namespace weft::test
