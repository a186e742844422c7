// What a free cloth keeps: momentum, angular momentum, its shape in free fall.
#include <gtest/gtest.h>

#include "forces/energy.h"
#include "integrators/integrator.h"
#include "simulation/cloth_system.h"
#include "support/cloth_forces.h"
#include "support/methods.h"

namespace weft::test {
namespace {

// A damped sheet, and a step at which every method is stable.
struct FreeSheet {
    SceneDescription scene;
    ClothModel cloth;
    ParticleState<double> state;
    static constexpr double dt = 5e-4;  // [s]; a quarter of the Verlets' limit

    explicit FreeSheet(Vec3d gravity) : scene(bare_sheet(8, 7, 1.0, 0.8)) {
        add_dashpots(scene, 2e-3);
        scene.forces.gravity = gravity;
        cloth = build_cloth(scene);
        state = rest_state<double>(cloth);
    }

    void run(std::string_view method, int steps) {
        ClothSystem<double> system(cloth, scene);
        const auto integrator = make_integrator<double>(method);
        integrator->prepare(system);
        for (int n = 0; n < steps; ++n) integrator->step(system, dt, state);
    }

    [[nodiscard]] Vec3d momentum() const {
        Vec3d sum{};
        cloth.layout.for_each(
            [&](std::size_t p, std::size_t s) { sum += cloth.masses[p] * state.v[s]; });
        return sum;
    }
    [[nodiscard]] Vec3d angular_momentum() const {
        Vec3d sum{};
        cloth.layout.for_each([&](std::size_t p, std::size_t s) {
            sum += cloth.masses[p] * cross(state.x[s], state.v[s]);
        });
        return sum;
    }
    [[nodiscard]] Vec3d centre() const {
        Vec3d sum{};
        cloth.layout.for_each(
            [&](std::size_t p, std::size_t s) { sum += cloth.masses[p] * state.x[s]; });
        return sum / cloth.total_mass();
    }
};

TEST(Momentum, IsKeptToRoundingWithoutExternalForce) {
    for (const IntegratorInfo& info : explicit_methods()) {
        FreeSheet sheet({0.0, 0.0, 0.0});
        disturb(sheet.cloth, sheet.state.x, 0.02, 1);
        disturb(sheet.cloth, sheet.state.v, 1.0, 2);
        const Vec3d start = sheet.momentum();
        const double size = sheet.cloth.total_mass() * 1.0;
        sheet.run(info.name, 2000);
        EXPECT_LT(length(sheet.momentum() - start), 2e-12 * size) << info.name;
    }
}

// Spring and dashpot pull along the line between two particles: no torque, however the sheet turns
// and rings. The splitting methods keep angular momentum to rounding, Runge-Kutta to its order.
TEST(AngularMomentum, IsKeptByASpinningSheetWithDashpots) {
    for (const IntegratorInfo& info : explicit_methods()) {
        FreeSheet sheet({0.0, 0.0, 0.0});
        const Vec3d spin{0.5, 1.0, 3.0};  // [1/s]
        const Vec3d centre = sheet.centre();
        sheet.cloth.layout.for_each([&](std::size_t, std::size_t s) {
            sheet.state.v.set(s, cross(spin, sheet.state.x[s] - centre));
        });
        const Vec3d start = sheet.angular_momentum();
        sheet.run(info.name, 4000);  // a turn
        const double tolerance = info.symplectic   ? 1e-11
                                 : info.order == 1 ? 1e-2
                                 : info.order == 2 ? 1e-5
                                                   : 1e-8;
        EXPECT_LT(length(sheet.angular_momentum() - start), tolerance * length(start)) << info.name;
    }
}

// Two masses turning about each other at the length where the spring holds them, k (l - L) = m w^2
// l/2: a rigid motion, which the dashpot, however strong, neither slows nor drains.
TEST(AngularMomentum, OfARigidPairIsNotDamped) {
    const double k = 50.0, mass = 0.1, spin = 4.0, rest = 1.0;  // [N/m], [kg], [1/s], [m]
    const double stretched = k * rest / (k - mass * spin * spin / 2);
    SceneDescription scene = bare_sheet(2, 2);
    const ClothModel pair = straight_chain(2, rest, mass, k, 0.5);
    ParticleState<double> state = rest_state<double>(pair);
    for (const std::size_t p : {0u, 1u}) {
        const Vec3d x{(p == 0 ? -0.5 : 0.5) * stretched, 0.0, 0.0};
        state.x.set(p, x);
        state.v.set(p, cross(Vec3d{0.0, 0.0, spin}, x));
    }
    const double start = energy<double>(pair, scene.forces, state.x.view(), state.v.view()).total();
    ClothSystem<double> system(pair, scene);
    const auto integrator = make_integrator<double>("rk4");
    integrator->prepare(system);
    for (int n = 0; n < 16'000; ++n) integrator->step(system, 1e-3, state);  // ten turns
    const Vec3d d = state.x[1] - state.x[0], v = state.v[1] - state.v[0];
    EXPECT_NEAR(length(d), stretched, 1e-9);
    EXPECT_NEAR(cross(d, v).z, spin * stretched * stretched, 1e-9);
    EXPECT_NEAR(energy<double>(pair, scene.forces, state.x.view(), state.v.view()).total(), start,
                1e-9);
    EXPECT_NEAR(std::atan2(d.y, d.x), std::remainder(16.0 * spin, 2 * M_PI), 1e-7);
}

// The method's own parabola under constant gravity after n steps.
Vec3d fallen(std::string_view method, int n, double dt, Vec3d v, Vec3d g) {
    const double squares = method == "forward-euler"      ? n * (n - 1.0) / 2
                           : method == "symplectic-euler" ? n * (n + 1.0) / 2
                                                          : n * (n * 1.0) / 2;
    return n * dt * v + squares * dt * dt * g;
}

constexpr Vec3d gravity{1.0, -9.81, 2.0}, thrown{3.0, 4.0, -1.0};

TEST(FreeFall, FollowsTheMethodsParabolaWithoutAnyStrain) {
    for (const IntegratorInfo& info : explicit_methods()) {
        FreeSheet sheet(gravity);
        sheet.cloth.layout.for_each(
            [&](std::size_t, std::size_t s) { sheet.state.v.set(s, thrown); });
        const int steps = 1000;
        sheet.run(info.name, steps);
        const Vec3d way = fallen(info.name, steps, FreeSheet::dt, thrown, gravity);
        double off = 0.0, off_speed = 0.0;
        sheet.cloth.layout.for_each([&](std::size_t p, std::size_t s) {
            const Vec3d moved = sheet.state.x[s] - sheet.cloth.rest_position(p);
            const Vec3d gained = sheet.state.v[s] - thrown;
            off = std::max(off, length(moved - way));
            off_speed = std::max(off_speed, length(gained - steps * FreeSheet::dt * gravity));
        });
        // Position Verlet adds differences of places: its rounding grows with the steps squared.
        const bool places = info.name.ends_with("verlet") && info.name != "velocity-verlet";
        EXPECT_LT(off, places ? 1e-10 : 1e-12) << info.name;
        EXPECT_LT(off_speed, places ? 1e-9 : 1e-11) << info.name;
        EXPECT_LT(std::abs(largest_strain<double>(sheet.cloth, sheet.state.x.view()).strain), 1e-12)
            << info.name;
    }
}

TEST(FreeFall, OfATornAndRingingSheetLeavesItsCentreOnTheParabola) {
    for (const IntegratorInfo& info : explicit_methods()) {
        FreeSheet sheet(gravity);
        disturb(sheet.cloth, sheet.state.x, 0.03, 1);
        disturb(sheet.cloth, sheet.state.v, 1.0, 2);
        const Vec3d start = sheet.centre(), velocity = sheet.momentum() / sheet.cloth.total_mass();
        sheet.run(info.name, 1000);
        EXPECT_LT(length(sheet.centre() - start -
                         fallen(info.name, 1000, FreeSheet::dt, velocity, gravity)),
                  1e-10)
            << info.name;
    }
}

}  // namespace
}  // namespace weft::test
