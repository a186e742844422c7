// Every method's step against its formula, written out here a second time on single vectors.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

#include "support/methods.h"
#include "support/spring_pendulum.h"

namespace weft::test {
namespace {

constexpr double dt = 0.03;  // [s]
constexpr int steps = 6;

struct Point {
    Vec3d x, v;
    double t = 0.0;
};
using Acceleration = std::function<Vec3d(double, Vec3d, Vec3d)>;
using Steps = std::function<std::vector<Point>(const Acceleration&, Point)>;

// Repeats a one-step formula.
Steps repeat(const std::function<Point(const Acceleration&, Point)>& step) {
    return [step](const Acceleration& a, Point point) {
        std::vector<Point> path;
        for (int n = 0; n < steps; ++n) {
            path.push_back(point = step(a, point));
        }
        return path;
    };
}

Point forward_euler(const Acceleration& a, Point p) {
    return {p.x + dt * p.v, p.v + dt * a(p.t, p.x, p.v), p.t + dt};
}

Point symplectic_euler(const Acceleration& a, Point p) {
    const Vec3d v = p.v + dt * a(p.t, p.x, p.v);
    return {p.x + dt * v, v, p.t + dt};
}

Point rk2(const Acceleration& a, Point p) {
    const double h = dt;
    const Vec3d kx1 = p.v, kv1 = a(p.t, p.x, p.v);
    const Vec3d kx2 = p.v + h / 2 * kv1;
    const Vec3d kv2 = a(p.t + h / 2, p.x + h / 2 * kx1, p.v + h / 2 * kv1);
    return {p.x + h * kx2, p.v + h * kv2, p.t + h};
}

Point rk3(const Acceleration& a, Point p) {
    const double h = dt;
    const Vec3d kx1 = p.v, kv1 = a(p.t, p.x, p.v);
    const Vec3d kx2 = p.v + h / 2 * kv1;
    const Vec3d kv2 = a(p.t + h / 2, p.x + h / 2 * kx1, kx2);
    const Vec3d kx3 = p.v - h * kv1 + 2 * h * kv2;
    const Vec3d kv3 = a(p.t + h, p.x - h * kx1 + 2 * h * kx2, kx3);
    return {p.x + h / 6 * (kx1 + 4.0 * kx2 + kx3), p.v + h / 6 * (kv1 + 4.0 * kv2 + kv3), p.t + h};
}

Point rk4(const Acceleration& a, Point p) {
    const double h = dt;
    const Vec3d kx1 = p.v, kv1 = a(p.t, p.x, p.v);
    const Vec3d kx2 = p.v + h / 2 * kv1, kv2 = a(p.t + h / 2, p.x + h / 2 * kx1, kx2);
    const Vec3d kx3 = p.v + h / 2 * kv2, kv3 = a(p.t + h / 2, p.x + h / 2 * kx2, kx3);
    const Vec3d kx4 = p.v + h * kv3, kv4 = a(p.t + h, p.x + h * kx3, kx4);
    return {p.x + h / 6 * (kx1 + 2.0 * kx2 + 2.0 * kx3 + kx4),
            p.v + h / 6 * (kv1 + 2.0 * kv2 + 2.0 * kv3 + kv4), p.t + h};
}

// Yoshida's composition from its definition: three leapfrogs (drift, kick, drift) of w1, w0, w1
// times the step, w1 = 1 / (2 - 2^(1/3)), w0 = -2^(1/3) / (2 - 2^(1/3)).
Point yoshida4(const Acceleration& a, Point p) {
    const double root = std::cbrt(2.0);
    for (const double w : {1 / (2 - root), -root / (2 - root), 1 / (2 - root)}) {
        p.x += w * dt / 2 * p.v;
        p.t += w * dt / 2;
        p.v += w * dt * a(p.t, p.x, p.v);
        p.x += w * dt / 2 * p.v;
        p.t += w * dt / 2;
    }
    return p;
}

// Forest and Ruth as they print it: x by theta/2, then v by theta, and so on.
Point forest_ruth(const Acceleration& a, Point p) {
    const double theta = 1 / (2 - std::cbrt(2.0));
    const auto drift = [&](double part) {
        p.x += part * dt * p.v;
        p.t += part * dt;
    };
    const auto kick = [&](double part) { p.v += part * dt * a(p.t, p.x, p.v); };
    drift(theta / 2);
    kick(theta);
    drift((1 - theta) / 2);
    kick(1 - 2 * theta);
    drift((1 - theta) / 2);
    kick(theta);
    drift(theta / 2);
    return p;
}

// x+ = 2 x - x_prev + a dt^2. Damping takes the one-sided (3 x - 4 x_prev + x_prevprev) / (2 dt);
// what is put out is the central difference of eq. 6.
std::vector<Point> verlet(const Acceleration& a, Point p) {
    Vec3d now = p.x, a_now = a(p.t, p.x, p.v);
    Vec3d before = p.x - dt * p.v + dt * dt / 2 * a_now;
    std::vector<Vec3d> places{before, now};
    for (int n = 1; n <= steps + 1; ++n) {
        const Vec3d next = 2.0 * now - before + dt * dt * a_now;
        a_now = a(p.t + n * dt, next, (3.0 * next - 4.0 * now + before) / (2 * dt));
        before = now;
        places.push_back(now = next);
    }
    std::vector<Point> path;
    for (std::size_t n = 2; n < 2 + steps; ++n) {
        path.push_back({places[n], (places[n + 1] - places[n - 1]) / (2 * dt),
                        p.t + dt * static_cast<double>(n - 1)});
    }
    return path;
}

// The next step takes the acceleration found with the predicted velocity.
std::vector<Point> velocity_verlet(const Acceleration& a, Point p) {
    std::vector<Point> path;
    Vec3d a_now = a(p.t, p.x, p.v);
    for (int n = 0; n < steps; ++n) {
        p.x = p.x + dt * p.v + dt * dt / 2 * a_now;
        p.t += dt;
        const Vec3d a_next = a(p.t, p.x, p.v + dt * a_now);
        p.v = p.v + dt / 2 * (a_now + a_next);
        a_now = a_next;
        path.push_back(p);
    }
    return path;
}

const std::map<std::string_view, Steps> formulas{
    {"forward-euler", repeat(forward_euler)},
    {"symplectic-euler", repeat(symplectic_euler)},
    {"verlet", verlet},
    {"time-corrected-verlet", verlet},  // the same at a fixed step
    {"velocity-verlet", velocity_verlet},
    {"rk2", repeat(rk2)},
    {"rk3", repeat(rk3)},
    {"rk4", repeat(rk4)},
    {"yoshida4", repeat(yoshida4)},
    {"forest-ruth", repeat(forest_ruth)},
};

TEST(UpdateFormulas, EveryMethodStepsAsItsFormula) {
    for (const IntegratorInfo& info : explicit_methods()) {
        ASSERT_TRUE(formulas.contains(info.name)) << info.name;
        for (const Pendulum kind : {Pendulum::free, Pendulum::damped, Pendulum::forced}) {
            SpringPendulum pendulum(kind);
            const Acceleration a = [&](double t, Vec3d x, Vec3d v) {
                return pendulum.acceleration(t, x, v);
            };
            const double start = 0.4;  // [s]; not 0, so that a lost time shows
            const auto path =
                formulas.at(info.name)(a, {pendulum_start.x, pendulum_start.v, start});
            const auto integrator = make_integrator<double>(info.name);
            integrator->prepare(pendulum);
            ParticleState<double> state = state_of(pendulum_start, start);
            for (const Point& point : path) {
                integrator->step(pendulum, dt, state);
                // Differences of places over dt lose log10(1/dt) digits.
                EXPECT_LT(length(state.x[0] - point.x), 2e-14) << info.name;
                EXPECT_LT(length(state.v[0] - point.v), 2e-13) << info.name;
                EXPECT_NEAR(state.time, point.t, 1e-14) << info.name;
            }
        }
    }
}

// x+ = x + (x - x_prev) dt/dt_prev + a dt (dt + dt_prev)/2 with steps that change by half and
// double.
TEST(UpdateFormulas, TimeCorrectedVerletTakesTheChangeOfStep) {
    SpringPendulum pendulum(Pendulum::free);
    const auto a = [&](Vec3d x) { return pendulum.acceleration(0.0, x, {}); };
    const auto integrator = make_integrator<double>("time-corrected-verlet");
    integrator->prepare(pendulum);
    ParticleState<double> state = state_of(pendulum_start);
    const std::vector<double> sizes{0.02, 0.02, 0.01, 0.01, 0.025, 0.02, 0.005};
    Vec3d now = pendulum_start.x;
    Vec3d before = now - sizes[0] * pendulum_start.v + sizes[0] * sizes[0] / 2 * a(now);
    double last = sizes[0];
    for (const double size : sizes) {
        integrator->step(pendulum, size, state);
        const Vec3d next = now + (size / last) * (now - before) + size * (size + last) / 2 * a(now);
        before = now;
        now = next;
        last = size;
        EXPECT_LT(length(state.x[0] - now), 2e-14);
        // The central difference about this step, were the next of the same size.
        EXPECT_LT(length(state.v[0] - ((now - before) / size + size / 2 * a(now))), 1e-12);
    }
}

// "verlet" knows no change of step: it starts anew from x and v.
TEST(UpdateFormulas, VerletStartsAnewWhenTheStepChanges) {
    SpringPendulum pendulum(Pendulum::free);
    const auto continued = make_integrator<double>("verlet"),
               fresh = make_integrator<double>("verlet");
    continued->prepare(pendulum);
    fresh->prepare(pendulum);
    ParticleState<double> a = state_of(pendulum_start);
    for (int n = 0; n < 3; ++n) continued->step(pendulum, 0.02, a);
    ParticleState<double> b = a;
    continued->step(pendulum, 0.01, a);
    fresh->step(pendulum, 0.01, b);
    EXPECT_EQ(a.x[0], b.x[0]);
    EXPECT_EQ(a.v[0], b.v[0]);
}

// The same error in the limit as at a fixed step: order 2 does hold when the step varies smoothly,
// and a sudden change costs nothing beyond it.
TEST(UpdateFormulas, TimeCorrectedVerletStaysAccurateWhenTheStepChanges) {
    const auto error_of = [](double size) {
        SpringPendulum pendulum(Pendulum::free);
        const auto integrator = make_integrator<double>("time-corrected-verlet");
        integrator->prepare(pendulum);
        ParticleState<double> state = state_of(pendulum_start);
        const auto half = static_cast<int>(std::lround(pendulum_end_time / 2 / size));
        for (int n = 0; n < half; ++n) integrator->step(pendulum, size, state);
        for (int n = 0; n < 2 * half; ++n) integrator->step(pendulum, size / 2, state);
        return distance(state, pendulum_end[0]);
    };
    const double coarse = error_of(1.3 / 512), fine = error_of(1.3 / 1024);
    EXPECT_LT(coarse, 1e-3);
    EXPECT_NEAR(coarse / fine, 4.0, 0.3);
}

}  // namespace
}  // namespace weft::test
