// Projective dynamics, XPBD and vertex block descent: what all three promise. They solve implicit
// Euler's step; run to convergence they must agree with one that is solved densely.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "integrators/projective_dynamics.h"
#include "integrators/runge_kutta.h"
#include "integrators/vbd.h"
#include "integrators/xpbd.h"
#include "math/parallel.h"
#include "support/cloth_scenes.h"
#include "support/order_fit.h"
#include "support/spring_system.h"

namespace weft::test {
namespace {

constexpr Vec3d gravity{0.0, -9.81, 0.0};

template <typename Real>
struct Method {
    std::string name;
    std::function<std::unique_ptr<Integrator<Real>>()> make;
};

/// At a number of iterations each: PD with and without L-BFGS, VBD with and without Chebyshev.
template <typename Real>
std::vector<Method<Real>> methods(int iterations) {
    using Settings = typename ProjectiveDynamics<Real>::Settings;
    return {{"projective-dynamics",
             [=] {
                 return std::make_unique<ProjectiveDynamics<Real>>(Settings{iterations, 0.0, 0});
             }},
            {"projective-dynamics, L-BFGS",
             [=] {
                 return std::make_unique<ProjectiveDynamics<Real>>(Settings{iterations, 0.0, 5});
             }},
            {"vbd", [=] { return std::make_unique<VertexBlockDescent<Real>>(iterations, 0.0); }},
            {"vbd, Chebyshev",
             [=] { return std::make_unique<VertexBlockDescent<Real>>(iterations, 0.9); }},
            {"xpbd", [=] { return std::make_unique<Xpbd<Real>>(iterations); }}};
}

/// 5 x 4 particles hung by two corners, one of which moves if asked to.
ClothModel small_cloth(double dashpot_ratio, bool moving = false) {
    SceneDescription scene = bare_sheet(5, 4);
    add_dashpots(scene, dashpot_ratio);
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    if (moving) scene.pins[1].motion = {{0.0, {}}, {0.4, {-0.2, 0.1, 0.3}}};
    return build_cloth(scene);
}

ParticleState<double> moving_state(const ClothModel& cloth) {
    ParticleState<double> state = rest_state<double>(cloth);
    disturb(cloth, state.x, 0.02, 3);
    disturb(cloth, state.v, 0.5, 4);
    const SpringSystem<double> system(cloth, gravity);
    system.constrain(0.0, state.x.view(), state.v.view());
    return state;
}

double distance_to_implicit_euler(const Method<double>& method, const ClothModel& cloth, double h,
                                  DashpotAlong along) {
    SpringSystem<double> system(cloth, gravity, 0.002);
    ParticleState<double> state = moving_state(cloth);
    const auto [residual, expected] = DenseImplicitEuler(system, h, state, along).solve();
    EXPECT_LT(residual, 1e-13);
    const auto integrator = method.make();
    integrator->prepare(system);
    EXPECT_TRUE(integrator->step(system, h, state).ok());
    return largest_distance(state.x, expected);
}

TEST(PositionMethods, AgreeWithImplicitEulerSolvedDenselyWithoutDashpots) {
    const ClothModel cloth = small_cloth(0.0);
    for (const Method<double>& method : methods<double>(3000)) {
        if (method.name == "xpbd") continue;  // below
        const double distance =
            distance_to_implicit_euler(method, cloth, 1.0 / 30, DashpotAlong::end);
        EXPECT_LT(distance, 1e-8) << method.name;
    }
}

TEST(PositionMethods, AgreeWithImplicitEulerWithDashpotsAsEachStates) {
    const ClothModel cloth = small_cloth(0.02);
    for (const Method<double>& method : methods<double>(3000)) {
        if (method.name == "xpbd") continue;
        const bool lagged = method.name.starts_with("projective");
        const auto along = lagged ? DashpotAlong::start : DashpotAlong::end;
        const auto other = lagged ? DashpotAlong::end : DashpotAlong::start;
        EXPECT_LT(distance_to_implicit_euler(method, cloth, 1.0 / 30, along), 1e-8) << method.name;
        EXPECT_GT(distance_to_implicit_euler(method, cloth, 1.0 / 30, other), 1e-5) << method.name;
    }
}

// m g / k = 0.1 kg * 9.81 m/s2 / 50 N/m = 19.62 mm.
double error_of_hanging_mass(const Method<double>& method, double h) {
    ClothModel cloth = straight_chain(2, 1.0, 0.1, 50.0);
    cloth.mesh_positions[1] = {0.0, -1.0, 0.0};
    pin_at_rest(cloth, 0);
    SpringSystem<double> system(cloth, gravity);
    ParticleState<double> state = rest_state<double>(cloth);
    state.x.set(1, {0.0, -1.01962, 0.0});
    const auto integrator = method.make();
    integrator->prepare(system);
    for (int n = 0; n < 100; ++n) integrator->step(system, h, state);
    return length(state.x[1] - Vec3d{0.0, -1.01962, 0.0}) + h * length(state.v[1]);
}

TEST(PositionMethods, HoldAHangingMassWhereTheSpringCarriesItAtAnyStep) {
    for (const int iterations : {1, 2, 20, 100}) {
        for (const Method<double>& method : methods<double>(iterations)) {
            for (const double h : {0.001, 0.1}) {
                // Chebyshev's iteration overshoots one spring, which a sweep solves: the mass
                // swings.
                const bool overshoots = method.name == "vbd, Chebyshev" && iterations < 100;
                EXPECT_LT(error_of_hanging_mass(method, h), overshoots ? 1e-4 : 1e-12)
                    << method.name << ", " << iterations << " iterations, h = " << h;
            }
        }
    }
}

TEST(PositionMethods, ConvergeWithOrderOneInTheStep) {
    const ClothModel cloth = small_cloth(0.01, true);
    const double end = 0.07;
    const auto run = [&](Integrator<double>& integrator, int steps) {
        SpringSystem<double> system(cloth, gravity, 0.002);
        ParticleState<double> state = moving_state(cloth);
        integrator.prepare(system);
        for (int n = 0; n < steps; ++n) integrator.step(system, end / steps, state);
        return state.x;
    };
    RungeKutta<double> rk4(classical4_table, chosen_instruction_set());
    const Vec3Array<double> exact = run(rk4, 2000);
    for (const Method<double>& method : methods<double>(60)) {
        std::vector<ErrorAtStep> errors;
        for (const int steps : {40, 80, 160, 320}) {
            errors.push_back({end / steps, largest_distance(run(*method.make(), steps), exact)});
        }
        EXPECT_NEAR(fitted_order(errors), 1.0, 0.08) << method.name;
        EXPECT_LT(errors.back().error, 2e-3) << method.name;
    }
}

template <typename Real>
void expect_finite_at_large_steps() {
    SceneDescription scene = bare_sheet(12, 9);
    scene.material.structural.stiffness = 1e5;
    scene.material.shear.stiffness = 4e4;
    scene.material.bend.stiffness = 5e3;
    scene.pins = {{EdgeSelection::top_left, {}}};
    const ClothModel cloth = build_cloth(scene);
    // omega_max^2 is at most 2 * (sum of k at a particle) / m, m = 0.2 kg/m2 / 88 per cell.
    const double explicit_limit = 2 / std::sqrt(2 * (4e5 + 1.6e5 + 2e4) / (0.2 / 88));
    for (const Method<Real>& method : methods<Real>(20)) {
        SpringSystem<Real> system(cloth, gravity);
        ParticleState<Real> state = disturbed_state<Real>(cloth, 0.1);
        system.constrain(0.0, state.x.view(), state.v.view());
        const auto integrator = method.make();
        integrator->prepare(system);
        for (int n = 0; n < 100; ++n) {
            ASSERT_TRUE(integrator->step(system, 100 * explicit_limit, state).ok());
        }
        for (std::size_t p = 0; p < cloth.particle_count; ++p) {
            ASSERT_TRUE(is_finite(state.x[cloth.slot(p)])) << method.name;
            ASSERT_LT(length(state.x[cloth.slot(p)]), 100) << method.name << " " << p;
        }
        EXPECT_GT(integrator->counts().newton_iterations, 100u) << method.name;
    }
}

TEST(PositionMethods, StayFiniteAt100TimesTheExplicitLimit) {
    expect_finite_at_large_steps<double>();
    expect_finite_at_large_steps<float>();
}

TEST(PositionMethods, PutPinsExactlyWhereTheyAre) {
    const ClothModel cloth = small_cloth(0.01, true);
    for (const Method<double>& method : methods<double>(3)) {
        SpringSystem<double> system(cloth, gravity);
        ParticleState<double> state = moving_state(cloth), expected = state;
        const auto integrator = method.make();
        integrator->prepare(system);
        for (int n = 0; n < 10; ++n) {
            integrator->step(system, 0.013, state);
            system.constrain(state.time, expected.x.view(), expected.v.view());
            for (const Pin& pin : cloth.pins) {
                const std::size_t slot = cloth.slot(pin.particle);
                EXPECT_EQ(state.x[slot], expected.x[slot]) << method.name;
                EXPECT_EQ(state.v[slot], expected.v[slot]) << method.name;
            }
        }
        EXPECT_GT(length(state.x[cloth.slot(4)] - cloth.rest_position(4)), 0.01);
    }
}

bool same_bits(const ParticleState<float>& a, const ParticleState<float>& b) {
    return std::equal(a.x.data(), a.x.data() + a.x.data_size(), b.x.data()) &&
           std::equal(a.v.data(), a.v.data() + a.v.data_size(), b.v.data());
}

TEST(PositionMethods, GiveTheSameBitsForAnyThreads) {
    SceneDescription scene = bare_sheet(150, 140);  // many grains a colour
    add_dashpots(scene, 0.01);
    scene.pins = {{EdgeSelection::left_edge, {}}};
    const ClothModel cloth = build_cloth(scene);
    for (const Method<float>& method : methods<float>(4)) {
        std::vector<ParticleState<float>> states;
        for (const int threads : {1, 2, 7}) {
            ThreadTeam team(threads);
            team.run([&] {
                SpringSystem<float> system(cloth, gravity);
                ParticleState<float> state = disturbed_state<float>(cloth, 0.005);
                const auto integrator = method.make();
                integrator->prepare(system);
                for (int n = 0; n < 3; ++n) integrator->step(system, 0.01, state);
                states.push_back(std::move(state));
            });
        }
        EXPECT_TRUE(same_bits(states[0], states[1])) << method.name;
        EXPECT_TRUE(same_bits(states[0], states[2])) << method.name;
    }
}

TEST(PositionMethods, GoBackToWhatWasSaved) {
    const ClothModel cloth = small_cloth(0.01, true);
    for (const Method<double>& method : methods<double>(3)) {
        SpringSystem<double> system(cloth, gravity);
        ParticleState<double> state = moving_state(cloth);
        const auto integrator = method.make();
        integrator->prepare(system);
        for (int n = 0; n < 3; ++n) integrator->step(system, 0.01, state);
        typename Integrator<double>::History history;
        integrator->save(history);
        const ParticleState<double> saved = state;
        for (int n = 0; n < 3; ++n) integrator->step(system, 0.01, state);
        const Vec3Array<double> first = state.x;
        for (int n = 0; n < 2; ++n) integrator->step(system, 0.02, state);  // and on, differently
        integrator->restore(history);
        state = saved;
        for (int n = 0; n < 3; ++n) integrator->step(system, 0.01, state);
        EXPECT_EQ(largest_distance(state.x, first), 0.0) << method.name;
    }
}

TEST(PositionMethods, MoveNothingButPinsWhereAllIsPinned) {
    ClothModel cloth = straight_chain(2, 1.0, 0.1, 50.0);
    pin_at_rest(cloth, 0);
    pin_at_rest(cloth, 1);
    for (const Method<double>& method : methods<double>(3)) {
        SpringSystem<double> system(cloth, gravity);
        ParticleState<double> state = rest_state<double>(cloth);
        const auto integrator = method.make();
        integrator->prepare(system);
        EXPECT_TRUE(integrator->step(system, 0.1, state).ok()) << method.name;
        EXPECT_EQ(largest_distance(state.x, rest_state<double>(cloth).x), 0.0) << method.name;
    }
}

TEST(PositionMethods, LeavePaddingZero) {
    const ClothModel cloth = small_cloth(0.01);  // rows of 5 in 16 slots
    for (const Method<double>& method : methods<double>(3)) {
        SpringSystem<double> system(cloth, gravity, 0.01);
        ParticleState<double> state = moving_state(cloth);
        const auto integrator = method.make();
        integrator->prepare(system);
        for (int n = 0; n < 3; ++n) integrator->step(system, 0.01, state);
        for (std::size_t s = 0; s < cloth.layout.slot_count(); ++s) {
            if (s % cloth.layout.row_stride() < 5) continue;
            EXPECT_EQ(state.x[s], Vec3d{}) << method.name;
            EXPECT_EQ(state.v[s], Vec3d{}) << method.name;
        }
    }
}

}  // namespace
}  // namespace weft::test
