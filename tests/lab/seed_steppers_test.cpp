// The seeds' updates do what their formulas say, to the last digit that a hand-written recursion
// gives.
#include "lab/settle/seed_steppers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <set>
#include <string>

namespace weft::lab {
namespace {

/// One mass: x'' = g - w^2 x - c x', along x; the other components stay zero.
class Oscillator final : public DynamicsSystem<double> {
public:
    double g = 0.0, w2 = 0.0, c = 0.0;
    int evaluations = 0;

    [[nodiscard]] std::size_t slot_count() const override { return 1; }
    void acceleration(double, ConstVec3View<double> x, ConstVec3View<double> v,
                      Vec3View<double> a) override {
        a.set(0, {at(x[0].x, v[0].x), 0.0, 0.0});
        ++evaluations;
    }
    void constrain(double, Vec3View<double>, Vec3View<double>) const override {}

    [[nodiscard]] double at(double x, double v) const { return g - w2 * x - c * v; }
};

ParticleState<double> state_at(double x, double v) {
    ParticleState<double> state{Vec3Array<double>(1), Vec3Array<double>(1), 0.0};
    state.x.set(0, {x, 0.0, 0.0});
    state.v.set(0, {v, 0.0, 0.0});
    return state;
}

/// Where the update takes the oscillator in so many steps.
ParticleState<double> flown(std::string_view update, Oscillator system, double x, double v,
                            double dt, int steps, double drag_rate = 0.0) {
    const auto integrator = make_seed_update(update, drag_rate);
    integrator->prepare(system);
    ParticleState<double> state = state_at(x, v);
    for (int n = 0; n < steps; ++n) {
        EXPECT_TRUE(integrator->step(system, dt, state).ok()) << update;
    }
    return state;
}

/// The same by a recursion over x, x_prev and x_prevprev, which begin a step apart by v.
template <typename Next>
double recursion(double x, double v, double dt, int steps, const Next& next) {
    double previous = x - dt * v, before = x - 2.0 * dt * v;
    for (int n = 0; n < steps; ++n) {
        const double x_next = next(x, previous, before);
        before = previous;
        previous = x;
        x = x_next;
    }
    return x;
}

constexpr double dt = 0.05;
constexpr int steps = 12;

TEST(SeedSteppers, PositionUpdatesAreTheirFormulas) {
    Oscillator s;
    s.g = -9.81;
    s.w2 = 100.0;
    s.c = 0.3;
    const double h2 = dt * dt;
    const auto expect = [&](std::string_view update, const auto& next, double drag = 0.0) {
        const double x = flown(update, s, 0.4, 0.7, dt, steps, drag).x[0].x;
        const double expected = recursion(0.4, 0.7, dt, steps, next);
        EXPECT_NEAR(x, expected, 1e-12 * (1.0 + std::abs(expected))) << update;
    };
    const auto backward = [&](double x, double p) { return s.at(x, (x - p) / dt); };
    const auto late = [&](double x, double b) { return s.at(x, (x - b) / (2.0 * dt)); };
    expect("verlet a dt^3",
           [&](double x, double p, double) { return 2.0 * x - p + backward(x, p) * h2 * dt; });
    expect("verlet P + P_prev",
           [&](double x, double p, double) { return x + (x + p) + backward(x, p) * h2; });
    expect("verlet v of eq. 6",
           [&](double x, double, double b) { return x + (x - b) / 2.0 + late(x, b) * h2 / 2.0; });
    expect("verlet v = (x - x_prev)/dt",
           [&](double x, double p, double) { return x + (x - p) + backward(x, p) * h2 / 2.0; });
    expect("verlet damped by eq. 6",
           [&](double x, double p, double b) { return 2.0 * x - p + late(x, b) * h2; });
    expect(
        "verlet (1 - d)(x - x_prev)",
        [&](double x, double p, double) {
            return x + (1.0 - 2.0 * dt) * (x - p) + backward(x, p) * h2;
        },
        2.0);
}

TEST(SeedSteppers, ScalingTheLastMoveIsDragOfThatRate) {
    Oscillator free;
    const double kept = 1.0 - 2.0 * dt;
    const double v = flown("verlet (1 - d)(x - x_prev)", free, 0.0, 1.0, dt, steps, 2.0).v[0].x;
    EXPECT_NEAR(v, std::pow(kept, steps), 1e-12);  // (x+ - x) / dt, from v = 1
}

TEST(SeedSteppers, PrintedPowerOfTheStepSlowsAFallBySixtyTimes) {
    // a dt^3 in place of a dt^2: what falls feels dt g.
    Oscillator fall;
    fall.g = -9.81;
    const double step = 0.016;
    const double printed = flown("verlet a dt^3", fall, 0.0, 0.0, step, 50).x[0].x;
    const double right = flown("euler v+ moves x", fall, 0.0, 0.0, step, 50).x[0].x;
    EXPECT_NEAR(right / printed, 62.5, 1e-9);  // 1 / dt
}

TEST(SeedSteppers, PrintedSignThrowsAParticleAwayInAFewSteps) {
    Oscillator still;  // no force at all
    EXPECT_DOUBLE_EQ(flown("verlet P + P_prev", still, 1.0, 0.0, dt, 1).x[0].x, 3.0);
    EXPECT_DOUBLE_EQ(flown("verlet P + P_prev", still, 1.0, 0.0, dt, 3).x[0].x, 17.0);
}

TEST(SeedSteppers, LimitsAreThoseOfTheirRecursions) {
    const auto far = [](std::string_view update, double omega_dt, int count) {
        Oscillator s;
        s.w2 = omega_dt * omega_dt / (dt * dt);
        return std::abs(flown(update, s, 1e-6, 0.0, dt, count).x[0].x) > 1.0;
    };
    // z^2 - 2 z + 1 + w^2 dt: stable to w = 2 / sqrt(dt); in these units w dt < 2 / sqrt(0.05).
    EXPECT_FALSE(far("verlet a dt^3", 0.99 * 2.0 / std::sqrt(dt), 2000));
    EXPECT_TRUE(far("verlet a dt^3", 1.01 * 2.0 / std::sqrt(dt), 2000));
    EXPECT_FALSE(far("verlet v of eq. 6", 1.99, 2000));
    EXPECT_TRUE(far("verlet v of eq. 6", 2.01, 2000));
    EXPECT_FALSE(far("verlet v = (x - x_prev)/dt", 2.82, 2000));  // 2 sqrt(2) = 2.828
    EXPECT_TRUE(far("verlet v = (x - x_prev)/dt", 2.84, 2000));
    EXPECT_TRUE(far("verlet v+ = v + a dt", 0.3, 1000));  // grows by 1 + (w dt)^2 / 4 a step
}

TEST(SeedSteppers, TaylorWithEulersVelocity) {
    Oscillator s;
    s.g = 2.0;
    s.w2 = 9.0;
    const ParticleState<double> state = flown("verlet v+ = v + a dt", s, 0.5, 1.0, dt, 1);
    const double a = s.at(0.5, 1.0);
    EXPECT_DOUBLE_EQ(state.x[0].x, 0.5 + dt + dt * dt / 2.0 * a);
    EXPECT_DOUBLE_EQ(state.v[0].x, 1.0 + dt * a);
}

TEST(SeedSteppers, NewVelocityMovingXIsSymplecticEuler) {
    Oscillator s;
    s.w2 = 25.0;
    const auto known = make_integrator<double>("symplectic-euler");
    known->prepare(s);
    ParticleState<double> expected = state_at(0.3, 0.1);
    for (int n = 0; n < steps; ++n) ASSERT_TRUE(known->step(s, dt, expected).ok());
    const ParticleState<double> state = flown("euler v+ moves x", s, 0.3, 0.1, dt, steps);
    EXPECT_EQ(state.x[0].x, expected.x[0].x);
    EXPECT_EQ(state.v[0].x, expected.v[0].x);
}

TEST(SeedSteppers, KuttaWithItsOwnK2SolvedFor) {
    // On y' = i w y, y = w x - i v: K2 = i w y / (1 - z/2), z = i w dt.
    Oscillator s;
    s.w2 = 400.0;
    const double w = 20.0;
    const std::complex<double> z(0.0, w * dt), one(1.0, 0.0);
    const std::complex<double> k2 = one / (one - 0.5 * z), k3 = one - z + 2.0 * z * k2;
    const std::complex<double> factor = one + z / 6.0 * (one + 4.0 * k2 + k3);
    const std::complex<double> y0(w * 0.2, -1.5), y1 = factor * y0;
    const ParticleState<double> state = flown("rk3 K2 implicit", s, 0.2, 1.5, dt, 1);
    EXPECT_NEAR(w * state.x[0].x, y1.real(), 1e-6);
    EXPECT_NEAR(-state.v[0].x, y1.imag(), 1e-6);
}

TEST(SeedSteppers, KuttaWithTheK2OfTheStepBeforeBeginsAsKuttas) {
    Oscillator s;
    s.w2 = 9.0;
    const auto kutta = make_integrator<double>("rk3");
    kutta->prepare(s);
    ParticleState<double> expected = state_at(0.3, 0.1);
    ASSERT_TRUE(kutta->step(s, dt, expected).ok());
    const ParticleState<double> first = flown("rk3 K2 of the step before", s, 0.3, 0.1, dt, 1);
    EXPECT_NEAR(first.x[0].x, expected.x[0].x, 1e-15);
    ASSERT_TRUE(kutta->step(s, dt, expected).ok());
    const ParticleState<double> second = flown("rk3 K2 of the step before", s, 0.3, 0.1, dt, 2);
    EXPECT_GT(std::abs(second.x[0].x - expected.x[0].x), 1e-6);
}

TEST(SeedSteppers, ImplicitK2ThatCannotBeFoundIsToldOf) {
    Oscillator s;
    s.w2 = 1e4;  // w dt = 5: turning K2 in on itself diverges
    const auto integrator = make_seed_update("rk3 K2 implicit");
    integrator->prepare(s);
    ParticleState<double> state = state_at(1.0, 0.0);
    const StepReport report = integrator->step(s, dt, state);
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.failure->reason, "K2 on its own right side is not found");
    EXPECT_EQ(state.x[0].x, 1.0);
}

TEST(SeedSteppers, EveryUpdateHasANameOfItsOwnAndASource) {
    std::set<std::string_view> names;
    for (const SeedUpdate& update : seed_updates()) {
        EXPECT_TRUE(names.insert(update.name).second) << update.name;
        EXPECT_FALSE(update.formula.empty());
        EXPECT_FALSE(update.source.empty());
        EXPECT_EQ(find_seed_update(update.name), &update);
        EXPECT_EQ(find_integrator(update.name), nullptr);
    }
    EXPECT_EQ(find_seed_update("verlet"), nullptr);
}

}  // namespace
}  // namespace weft::lab
