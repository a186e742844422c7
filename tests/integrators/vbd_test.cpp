// Vertex block descent: its sweep, its first guess, its acceleration.
#include "integrators/vbd.h"

#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "support/spring_system.h"

namespace weft::test {
namespace {

constexpr Vec3d gravity{0.0, -9.81, 0.0};

/// A mass of 0.1 kg on a spring of 1 m and k = 50 N/m that hangs from the origin.
ClothModel hanging_mass(double damping = 0.0) {
    ClothModel cloth = straight_chain(2, 1.0, 0.1, 50.0, damping);
    cloth.mesh_positions[1] = {0.0, -1.0, 0.0};
    pin_at_rest(cloth, 0);
    return cloth;
}

// One sweep from y = 1.1 m along the spring, h = 0.1 s, at rest at 1 m before, c = 2 N s/m:
//     H = m/h^2 + k + c/h = 10 + 50 + 20,  f = -k 0.1 - (c/h) 0.1 = -7 N,  x = 1.1 - 7/80.
TEST(VertexBlockDescent, SolvesTheBlockOfOneParticle) {
    const ClothModel cloth = hanging_mass(2.0);
    SpringSystem<double> system(cloth, {0.0, 0.0, 0.0});
    ParticleState<double> state = rest_state<double>(cloth);
    state.v.set(1, {0.0, -1.0, 0.0});
    VertexBlockDescent<double> vbd(1, 0.0);
    vbd.prepare(system);
    vbd.step(system, 0.1, state);
    EXPECT_NEAR(state.x[1].y, -(1.1 - 7.0 / 80), 1e-14);
    EXPECT_EQ(vbd.counts().newton_iterations, 1u);
}

// A compressed spring of k = 50, L = 1 to l = 0.8: across it the Hessian 50 (1 - 1/0.8) < 0 is left
// out, along it stays. m/h^2 = 10: H = 10 across and 60 along; y = 0.1 m aside gives f aside 0.
TEST(VertexBlockDescent, LeavesOutTheNegativePartOfACompressedSpring) {
    const ClothModel cloth = hanging_mass();
    SpringSystem<double> system(cloth, {0.0, 0.0, 0.0});
    ParticleState<double> state = rest_state<double>(cloth);
    state.x.set(1, {0.0, -0.8, 0.0});
    VertexBlockDescent<double> vbd(1, 0.0);
    vbd.prepare(system);
    vbd.step(system, 0.1, state);
    EXPECT_NEAR(state.x[1].y, -(0.8 + 50 * 0.2 / 60), 1e-14);
    EXPECT_EQ(state.x[1].x, 0.0);
}

// Hanging at rest, the last step showed no acceleration, so the next starts from where it is: one
// sweep keeps it there to rounding. Started anew it guesses a free fall, and a chain of three sags.
TEST(VertexBlockDescent, StartsFromWhatTheLastStepShowed) {
    ClothModel chain = straight_chain(4, 1.0, 0.1, 50.0);
    const double sag = 0.1 * 9.81 / 50;
    chain.mesh_positions = {{}, {0, -1 - 3 * sag, 0}, {0, -2 - 5 * sag, 0}, {0, -3 - 6 * sag, 0}};
    pin_at_rest(chain, 0);
    SpringSystem<double> system(chain, gravity);
    const ParticleState<double> rest = rest_state<double>(chain);
    VertexBlockDescent<double> vbd(1, 0.0);
    vbd.prepare(system);
    Integrator<double>::History at_rest;
    at_rest.arrays.emplace_back(4);  // no acceleration
    at_rest.last_step = 1.0;
    vbd.restore(at_rest);
    ParticleState<double> state = rest;
    for (int n = 0; n < 10; ++n) vbd.step(system, 0.1, state);
    EXPECT_LT(largest_distance(state.x, rest.x), 1e-12);
    vbd.restart();
    vbd.step(system, 0.1, state);
    EXPECT_GT(largest_distance(state.x, rest.x), 1e-3);
}

TEST(VertexBlockDescent, ConvergesFasterWithChebyshev) {
    SceneDescription scene = bare_sheet(17, 13);
    scene.material.structural.stiffness = 1000.0;
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    const ClothModel cloth = build_cloth(scene);
    const auto positions = [&](int iterations, double rho) {
        SpringSystem<double> system(cloth, gravity);
        ParticleState<double> state = rest_state<double>(cloth);
        disturb(cloth, state.v, 0.1, 3);
        system.constrain(0.0, state.x.view(), state.v.view());
        VertexBlockDescent<double> vbd(iterations, rho);
        vbd.prepare(system);
        vbd.step(system, 1.0 / 60, state);
        return state.x;
    };
    const Vec3Array<double> limit = positions(5000, 0.0);
    const double plain = largest_distance(positions(400, 0.0), limit);
    const double accelerated = largest_distance(positions(400, 0.95), limit);
    EXPECT_LT(20 * accelerated, plain);
}

}  // namespace
}  // namespace weft::test
