// XPBD: its limit, what a sweep of it is, and what it conserves.
#include "integrators/xpbd.h"

#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "support/spring_system.h"

namespace weft::test {
namespace {

constexpr Vec3d gravity{0.0, -9.81, 0.0};

ParticleState<double> step_once(const ClothModel& cloth, int iterations, double h,
                                const ParticleState<double>& start) {
    SpringSystem<double> system(cloth, gravity);
    ParticleState<double> state = start;
    Xpbd<double> xpbd(iterations);
    xpbd.prepare(system);
    xpbd.step(system, h, state);
    return state;
}

double distance_to_implicit_euler(const ClothModel& cloth, double h,
                                  const ParticleState<double>& state) {
    SpringSystem<double> system(cloth, gravity);
    const auto [residual, expected] =
        DenseImplicitEuler(system, h, state, DashpotAlong::end).solve();
    EXPECT_LT(residual, 1e-13);
    return largest_distance(step_once(cloth, 5000, h, state).x, expected);
}

// Eq. 26 by hand: masses 0.1 and 0.3 kg, k = 50 N/m, c = 2 N s/m, L = 1 m, h = 0.1 s; no gravity,
// at rest but for 1 m of stretch and 0.5 m/s apart.
TEST(Xpbd, SolvesOneSpringAsThePaperWritesIt) {
    ClothModel cloth = straight_chain(2, 1.0, 0.1, 50.0, 2.0);
    cloth.masses[1] = 0.3;
    SpringSystem<double> system(cloth, {0.0, 0.0, 0.0});
    ParticleState<double> state = rest_state<double>(cloth);
    state.x.set(1, {2.0, 0.0, 0.0});
    state.v.set(1, {0.5, 0.0, 0.0});
    Xpbd<double> xpbd;
    xpbd.prepare(system);
    xpbd.step(system, 0.1, state);
    const double alpha = 1 / (50.0 * 0.01), gamma = 2.0 / (50.0 * 0.1), w = 1 / 0.1 + 1 / 0.3;
    const double lambda = (-1.05 - gamma * 0.05) / ((1 + gamma) * w + alpha);
    EXPECT_NEAR(state.x[0].x, -lambda / 0.1, 1e-14);
    EXPECT_NEAR(state.x[1].x, 2.05 + lambda / 0.3, 1e-14);
    EXPECT_NEAR(state.v[0].x, -lambda / 0.1 / 0.1, 1e-13);
}

// The spring's length after a step is implicit Euler's: k = 0 leaves (m / h) dv = -c v, with the
// reduced mass m = 0.05 kg: v+ = v / (1 + c h / m) = 1 / (1 + 2 * 0.1 / 0.05) = 0.2.
TEST(Xpbd, TakesADashpotWithoutASpring) {
    ClothModel cloth = straight_chain(2, 1.0, 0.1, 0.0, 2.0);
    SpringSystem<double> system(cloth, {0.0, 0.0, 0.0});
    ParticleState<double> state = rest_state<double>(cloth);
    state.v.set(1, {1.0, 0.0, 0.0});
    Xpbd<double> xpbd;
    xpbd.prepare(system);
    xpbd.step(system, 0.1, state);
    EXPECT_NEAR(state.v[1].x - state.v[0].x, 0.2, 1e-14);
}

TEST(Xpbd, IsImplicitEulerOnALineWhenConverged) {
    ClothModel chain = straight_chain(6, 0.2, 0.01, 80.0, 0.05);
    for (Vec3d& x : chain.mesh_positions) x = {0.0, -x.x, 0.0};
    pin_at_rest(chain, 0);
    ParticleState<double> state = rest_state<double>(chain);
    state.v.set(2, {0.0, 0.3, 0.0});
    state.v.set(5, {0.0, -0.4, 0.0});
    EXPECT_LT(distance_to_implicit_euler(chain, 1.0 / 30, state), 1e-12);
}

// Off a line the impulses' directions differ from the last ones: an error of order 4 a step, two
// above implicit Euler's own.
TEST(Xpbd, IsNearImplicitEulerWhenConverged) {
    SceneDescription scene = bare_sheet(5, 4);
    add_dashpots(scene, 0.005);
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    const ClothModel cloth = build_cloth(scene);
    ParticleState<double> state = rest_state<double>(cloth);
    disturb(cloth, state.x, 0.02, 3);
    disturb(cloth, state.v, 0.5, 4);
    const SpringSystem<double> system(cloth, gravity);
    system.constrain(0.0, state.x.view(), state.v.view());
    EXPECT_LT(distance_to_implicit_euler(cloth, 1.0 / 30, state), 5e-4);
    const double large = distance_to_implicit_euler(cloth, 1.0 / 480, state);
    const double small = distance_to_implicit_euler(cloth, 1.0 / 960, state);
    EXPECT_LT(large, 5e-6);
    EXPECT_GT(large, 10 * small);
}

TEST(Xpbd, ConservesMomentumWithoutPins) {
    SceneDescription scene = bare_sheet(9, 7);
    add_dashpots(scene, 0.01);
    const ClothModel cloth = build_cloth(scene);
    SpringSystem<double> system(cloth, {0.0, 0.0, 0.0});
    ParticleState<double> state = disturbed_state<double>(cloth, 0.12);
    const auto momentum = [&] {
        Vec3d sum{};
        for (std::size_t p = 0; p < cloth.particle_count; ++p) {
            sum += cloth.masses[p] * state.v[cloth.slot(p)];
        }
        return sum;
    };
    const Vec3d before = momentum();
    Xpbd<double> xpbd(3);
    xpbd.prepare(system);
    for (int n = 0; n < 200; ++n) xpbd.step(system, 0.01, state);
    EXPECT_GT(length(before), 1e-3);
    EXPECT_LT(length(momentum() - before), 1e-13);
    EXPECT_EQ(xpbd.counts().newton_iterations, 600u);
    EXPECT_EQ(xpbd.counts().evaluations, 200u);
}

}  // namespace
}  // namespace weft::test
