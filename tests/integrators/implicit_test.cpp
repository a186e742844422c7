// Implicit methods: their equations, their stability, what they do to energy, and what a stage that
// cannot be solved leaves.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "integrators/implicit.h"
#include "support/methods.h"
#include "support/spring_pendulum.h"

namespace weft::test {
namespace {

constexpr double dt = 0.05;  // [s]

std::unique_ptr<Integrator<double>> tight(std::string_view method) {
    IntegratorSettings settings;
    settings.tolerance = 1e-13;
    return make_integrator<double>(method, settings);
}

ParticleState<double> stepped(SpringPendulum& pendulum, std::string_view method, int steps,
                              double start_time = 0.4) {
    const auto integrator = tight(method);
    integrator->prepare(pendulum);
    ParticleState<double> state = state_of(pendulum_start, start_time);
    for (int n = 0; n < steps; ++n) {
        EXPECT_TRUE(integrator->step(pendulum, dt, state).ok()) << method;
    }
    return state;
}

struct Slope {
    Vec3d v, a;
};
Slope slope_of(const SpringPendulum& pendulum, double t, Vec3d x, Vec3d v) {
    return {v, pendulum.acceleration(t, x, v)};
}

// A step satisfies the method's own equation, written out here from its definition.
TEST(ImplicitMethods, StepsSatisfyTheirEquations) {
    const double t = 0.4, h = dt;
    for (const Pendulum kind : {Pendulum::free, Pendulum::damped, Pendulum::forced}) {
        SpringPendulum pendulum(kind);
        const auto [x, v] = pendulum_start;
        const auto residual = [&](std::string_view method, auto equation) {
            const ParticleState<double> end = stepped(pendulum, method, 1);
            const auto [rx, rv] = equation(end.x[0], end.v[0]);
            EXPECT_LT(length(rx), 1e-13) << method;
            EXPECT_LT(length(rv), 2e-11) << method;
        };
        residual("implicit-euler", [&](Vec3d x1, Vec3d v1) {
            const Slope f = slope_of(pendulum, t + h, x1, v1);
            return PointState{x1 - x - h * f.v, v1 - v - h * f.a};
        });
        residual("implicit-midpoint", [&](Vec3d x1, Vec3d v1) {
            const Slope f = slope_of(pendulum, t + h / 2, 0.5 * (x + x1), 0.5 * (v + v1));
            return PointState{x1 - x - h * f.v, v1 - v - h * f.a};
        });
        residual("trapezoidal", [&](Vec3d x1, Vec3d v1) {
            const Slope f = slope_of(pendulum, t, x, v), g = slope_of(pendulum, t + h, x1, v1);
            return PointState{x1 - x - h / 2 * (f.v + g.v), v1 - v - h / 2 * (f.a + g.a)};
        });
    }
}

// y2 = 4/3 y1 - 1/3 y0 + 2/3 h f(y2), whatever y1 is.
TEST(ImplicitMethods, Bdf2SatisfiesItsTwoStepFormula) {
    SpringPendulum pendulum(Pendulum::damped);
    const ParticleState<double> one = stepped(pendulum, "bdf2", 1),
                                two = stepped(pendulum, "bdf2", 2);
    const Slope f = slope_of(pendulum, two.time, two.x[0], two.v[0]);
    const auto [x, v] = pendulum_start;
    EXPECT_LT(length(two.x[0] - 4.0 / 3 * one.x[0] + 1.0 / 3 * x - 2.0 / 3 * dt * f.v), 1e-13);
    EXPECT_LT(length(two.v[0] - 4.0 / 3 * one.v[0] + 1.0 / 3 * v - 2.0 / 3 * dt * f.a), 2e-11);
}

// Conditions of order 1 and 2, and c_i = sum a_ij.
TEST(ImplicitTables, MeetTheirOrderConditions) {
    struct Case {
        const DirkTable* table;
        int order;
    };
    for (const auto [table, order] : {Case{&implicit_euler_table, 1},
                                      {&implicit_midpoint_table, 2},
                                      {&trapezoidal_table, 2},
                                      {&tr_bdf2_table, 2},
                                      {&sdirk2_table, 2}}) {
        double b = 0.0, bc = 0.0;
        for (std::size_t i = 0; i < DirkTable::max_stages; ++i) {
            double c = 0.0;
            for (std::size_t j = 0; j < DirkTable::max_stages; ++j) c += table->a[i][j];
            EXPECT_NEAR(c, table->c[i], 1e-15);
            b += table->b[i];
            bc += table->b[i] * table->c[i];
        }
        EXPECT_NEAR(b, 1.0, 1e-15);
        if (order > 1) {
            EXPECT_NEAR(bc, 0.5, 1e-15);
        }
    }
}

// The growth on a mode is |R(z)| of the textbook's stability function: A-stable all, L-stable where
// they damp what they cannot resolve.
TEST(ImplicitStability, IsTheTextbooks) {
    using Complex = std::complex<double>;
    const auto largest = [](double y, double zeta, auto r) {
        const Complex root = std::sqrt(Complex(zeta * zeta - 1.0));
        return std::max(std::abs(r(y * (-zeta + root))), std::abs(r(y * (-zeta - root))));
    };
    const double g = 1.0 - 1.0 / std::sqrt(2.0);
    for (const double zeta : {0.0, 0.1, 1.0, 4.0}) {
        for (const double y : {0.01, 0.7, 3.0, 1e3}) {
            const auto expect = [&](std::string_view method, auto r) {
                EXPECT_NEAR(amplification(method, y, zeta), largest(y, zeta, r), 1e-12)
                    << method << " " << y << " " << zeta;
            };
            expect("implicit-euler", [](Complex z) { return 1.0 / (1.0 - z); });
            expect("baraff-witkin", [](Complex z) { return 1.0 / (1.0 - z); });
            expect("implicit-midpoint", [](Complex z) { return (2.0 + z) / (2.0 - z); });
            expect("trapezoidal", [](Complex z) { return (2.0 + z) / (2.0 - z); });
            expect("sdirk2", [&](Complex z) {
                return (1.0 + (1.0 - 2.0 * g) * z) / ((1.0 - g * z) * (1.0 - g * z));
            });
            // TR-BDF2 is sdirk2's equal on linear problems (Hosea, Shampine 1996).
            expect("tr-bdf2", [&](Complex z) {
                return (1.0 + (1.0 - 2.0 * g) * z) / ((1.0 - g * z) * (1.0 - g * z));
            });
        }
    }
}

TEST(ImplicitStability, IsUnconditional) {
    for (const IntegratorInfo& info :
         methods_of({IntegratorKind::implicit, IntegratorKind::by_springs})) {
        for (const double zeta : {0.0, 0.01, 0.5, 1.0, 20.0}) {
            EXPECT_TRUE(std::isinf(stability_limit(info.name, zeta))) << info.name;
            for (double y = 1e-3; y < 1e6; y *= 1.3) {
                ASSERT_LE(amplification(info.name, y, zeta), 1.0 + 1e-12)
                    << info.name << " " << y << " " << zeta;
            }
        }
    }
}

TEST(ImplicitStability, DampsStiffModesWhereItIsL) {
    for (const char* method : {"implicit-euler", "bdf2", "tr-bdf2", "sdirk2"}) {
        EXPECT_LT(amplification(method, 1e6, 0.0), 1e-2) << method;
    }
    for (const char* method : {"implicit-midpoint", "trapezoidal"}) {
        EXPECT_NEAR(amplification(method, 1e6, 0.0), 1.0, 1e-9) << method;
    }
}

double energy_of(const ParticleState<double>& state) {
    const Vec3d x = state.x[0], v = state.v[0];
    const double stretch = length(x) - 1.0;
    return 0.5 * dot(v, v) + 12.5 * stretch * stretch + 9.81 * x.y;
}

// Symplectic: no drift. The motion's energy is about 13 J.
TEST(ImplicitEnergy, IsKeptByTheMidpointRuleOver10000Steps) {
    SpringPendulum pendulum(Pendulum::free);
    const auto integrator = tight("implicit-midpoint");
    integrator->prepare(pendulum);
    ParticleState<double> state = state_of(pendulum_start);
    const double start = energy_of(state);
    double largest = 0.0;
    for (int n = 0; n < 10'000; ++n) {
        ASSERT_TRUE(integrator->step(pendulum, 0.002, state).ok());
        largest = std::max(largest, std::abs(energy_of(state) - start));
    }
    EXPECT_LT(largest, 1e-3 * 13.0);
    EXPECT_GT(largest, 1e-6);
}

// On one mode, x'' = -w^2 x, every step of implicit Euler divides the energy by 1 + (w h)^2: a
// small radial swing about the spring's rest, hung without gravity at its natural length.
TEST(ImplicitEnergy, OfImplicitEulerFallsAsItsLinearTheory) {
    SpringPendulum pendulum(Pendulum::free);
    const Vec3d rest{0.0, -1.0 - 9.81 / 25.0, 0.0};
    const auto integrator = tight("implicit-euler");
    integrator->prepare(pendulum);
    ParticleState<double> state = state_of({rest + Vec3d{0.0, 1e-3, 0.0}, {}});
    const auto energy = [&] {
        const Vec3d d = state.x[0] - rest, v = state.v[0];
        return 0.5 * dot(v, v) + 12.5 * dot(d, d);
    };
    const double h = 0.02, factor = 1.0 + 25.0 * h * h;
    double expected = energy();
    for (int n = 0; n < 100; ++n) {
        ASSERT_TRUE(integrator->step(pendulum, h, state).ok());
        expected /= factor;
        ASSERT_NEAR(energy() / expected, 1.0, 1e-6);
    }
    EXPECT_LT(expected, 0.4 * 12.5e-6);
}

// One linear solve: implicit Euler's equation, linearised at x + h v.
TEST(BaraffWitkin, SolvesOneLinearSystemAStep) {
    SpringPendulum pendulum(Pendulum::free);
    const auto integrator = make_integrator<double>("baraff-witkin");
    integrator->prepare(pendulum);
    const auto [x, v] = pendulum_start;
    const double h = 0.02;
    ParticleState<double> state = state_of(pendulum_start);
    ASSERT_TRUE(integrator->step(pendulum, h, state).ok());
    EXPECT_EQ(integrator->counts().newton_iterations, 1u);
    EXPECT_EQ(pendulum.evaluations, 2);  // at the guess, and whether it overshot
    // (1 + h^2 K) d = h^2 f(x + h v), K = 25 (n n^T + (1 - 1/r) (1 - n n^T)), stretched.
    const Vec3d guess = x + h * v, d = state.x[0] - guess;
    const double r = length(guess);
    const Vec3d n = guess / r;
    const Vec3d kd = 25.0 * (dot(n, d) * n + (1.0 - 1.0 / r) * (d - dot(n, d) * n));
    EXPECT_LT(length(d + h * h * kd - h * h * pendulum.acceleration(0.0, guess, {})), 1e-15);
    EXPECT_LT(length(state.v[0] - (state.x[0] - x) / h), 1e-13);
}

// A spring that lies level at rest length resists nothing across: its one linear solve falls by
// h^2 g, 39 m, which stretches it to 39 times its length.
TEST(BaraffWitkin, ShortensASolutionThatOvershoots) {
    SpringPendulum pendulum(Pendulum::free);
    const auto integrator = make_integrator<double>("baraff-witkin");
    integrator->prepare(pendulum);
    const double h = 2.0;
    ParticleState<double> state = state_of({{1.0, 0.0, 0.0}, {}});
    ASSERT_TRUE(integrator->step(pendulum, h, state).ok());
    EXPECT_EQ(integrator->counts().newton_iterations, 1u);
    const Vec3d x = state.x[0];
    EXPECT_LT(x.y, -0.1);
    EXPECT_GT(x.y, -3.0);
    // Across, the unbalanced force points back by half of what it pointed forward at most.
    EXPECT_LE(pendulum.acceleration(h, x, {}).y - x.y / (h * h), 0.5 * 9.81);
}

TEST(ImplicitCounts, AreOfEveryIteration) {
    SpringPendulum pendulum(Pendulum::free);
    const auto integrator = tight("tr-bdf2");
    integrator->prepare(pendulum);
    ParticleState<double> state = state_of(pendulum_start);
    for (int n = 0; n < 3; ++n) ASSERT_TRUE(integrator->step(pendulum, dt, state).ok());
    const SolverCounts counts = integrator->counts();
    EXPECT_EQ(counts.evaluations, static_cast<std::size_t>(pendulum.evaluations));
    EXPECT_GE(counts.newton_iterations, 12u);  // two stages a step, two or more iterations each
    EXPECT_EQ(counts.linear_iterations, counts.newton_iterations);
}

// Not solved: the state is as it was, and the report says how far it came.
TEST(ImplicitFailure, LeavesTheStateAndSaysWhy) {
    for (const char* method : {"implicit-euler", "implicit-midpoint", "tr-bdf2", "bdf2"}) {
        SpringPendulum pendulum(Pendulum::free);
        IntegratorSettings settings;
        settings.tolerance = 1e-300;
        settings.iterations = 3;
        const auto integrator = make_integrator<double>(method, settings);
        integrator->prepare(pendulum);
        ParticleState<double> state = state_of(pendulum_start);
        const StepReport report = integrator->step(pendulum, dt, state);
        ASSERT_FALSE(report.ok()) << method;
        EXPECT_NE(report.failure->reason.find("after 3 iterations"), std::string::npos)
            << report.failure->reason;
        EXPECT_NE(report.failure->advice.find("integrator.tolerance"), std::string::npos);
        EXPECT_EQ(state.x[0], pendulum_start.x);
        EXPECT_EQ(state.v[0], pendulum_start.v);
        EXPECT_EQ(state.time, 0.0);
    }
}

TEST(ImplicitFailure, OfForcesThatAreNotFiniteIsToldAsSuch) {
    SpringPendulum pendulum(Pendulum::free);
    const auto integrator = tight("implicit-euler");
    integrator->prepare(pendulum);
    ParticleState<double> state = state_of({{NAN, 0.0, 0.0}, {}});
    const StepReport report = integrator->step(pendulum, dt, state);
    ASSERT_FALSE(report.ok());
    EXPECT_NE(report.failure->reason.find("not finite"), std::string::npos);
}

}  // namespace
}  // namespace weft::test
