// How the embedded pairs choose their steps: rejections, times that frames fall on, pins, going
// back, failure, single precision, threads.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include "integrators/embedded_runge_kutta.h"
#include "math/parallel.h"
#include "support/extrapolation.h"
#include "support/spring_pendulum.h"

namespace weft::test {
namespace {

// Particles in x alone, a = force(t, x, v); the particle in slot 0 can be a pin that moves.
template <typename Real>
class LineSystem final : public DynamicsSystem<Real> {
public:
    using Force = std::function<double(double, double, double)>;
    explicit LineSystem(Force force, std::size_t count = 1, bool pinned = false)
        : force_(std::move(force)), count_(count), pinned_(pinned) {}

    [[nodiscard]] std::size_t slot_count() const override { return count_; }
    void acceleration(double t, ConstVec3View<Real> x, ConstVec3View<Real> v,
                      Vec3View<Real> a) override {
        for (std::size_t s = pinned_ ? 1 : 0; s < count_; ++s) {
            const double left = pinned_ && s == 1 ? static_cast<double>(x.x[0]) : 0.0;
            a.x[s] = static_cast<Real>(
                force_(t, static_cast<double>(x.x[s]) - left, static_cast<double>(v.x[s])));
        }
    }
    void constrain(double t, Vec3View<Real> x, Vec3View<Real> v) const override {
        if (!pinned_) return;
        x.set(0, {static_cast<Real>(std::sin(t)), Real{2}, Real{0}});
        v.set(0, {static_cast<Real>(std::cos(t)), Real{0}, Real{0}});
    }

private:
    Force force_;
    std::size_t count_;
    bool pinned_;
};

template <typename Real>
ParticleState<Real> line_state(std::size_t count, double x, double v) {
    ParticleState<Real> state{Vec3Array<Real>(count), Vec3Array<Real>(count), 0.0};
    for (std::size_t s = 0; s < count; ++s) {
        const double part = 1.0 + static_cast<double>(s) / static_cast<double>(count);
        state.x.set(s, {static_cast<Real>(part * x), Real{0}, Real{0}});
        state.v.set(s, {static_cast<Real>(part * v), Real{0}, Real{0}});
    }
    return state;
}

template <typename Real>
bool same_bits(const ParticleState<Real>& a, const ParticleState<Real>& b) {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    bool same = a.time == b.time;
    for (std::size_t n = 0; n < a.x.data_size(); ++n) {
        same = same && std::bit_cast<Bits>(a.x.data()[n]) == std::bit_cast<Bits>(b.x.data()[n]) &&
               std::bit_cast<Bits>(a.v.data()[n]) == std::bit_cast<Bits>(b.v.data()[n]);
    }
    return same;
}

template <typename Real = double>
EmbeddedRungeKutta<Real> dopri5(double tolerance) {
    return {dopri5_table, {.tolerance = tolerance}, InstructionSet::scalar};
}
template <typename Real = double>
EmbeddedRungeKutta<Real> bosh3(double tolerance) {
    return {bosh3_table, {.tolerance = tolerance}, InstructionSet::scalar};
}

double spring(double /*t*/, double x, double /*v*/) {
    return -25.0 * x;
}

TEST(StepChoice, RejectsStepsThatAKickMakesWrong) {
    // At rest until 0.5 s, then a constant 500 m/s2 beside the spring: 20 m (1 - cos 5 (t - 0.5)).
    const auto kicked = [](double t, double x, double) {
        return -25.0 * x + (t > 0.5 ? 500.0 : 0.0);
    };
    for (const auto& make : {dopri5<double>, bosh3<double>}) {
        LineSystem<double> system(kicked);
        auto method = make(1e-5);
        method.prepare(system);
        ParticleState<double> state = line_state<double>(1, 0.0, 0.0);
        for (int n = 0; n < 60; ++n) ASSERT_TRUE(method.step(system, 1.0 / 60, state).ok());
        EXPECT_GT(method.counts().rejected, 0u);
        EXPECT_LT(method.counts().rejected, 25u);
        // The jump falls into one step, of h: e_v = tolerance / h, and of x a fifth of that.
        EXPECT_NEAR(state.x[0].x, 20.0 * (1.0 - std::cos(2.5)), 2e-2);
    }
}

TEST(StepChoice, PutsFramesOnTheirTimesWithoutFurtherSteps) {
    const auto run = [](int frames) {
        SpringPendulum pendulum(Pendulum::damped);
        auto method = dopri5(1e-10);  // steps of some 10 ms
        method.prepare(pendulum);
        ParticleState<double> state = state_of(pendulum_start);
        for (int n = 0; n < frames; ++n) {
            const double before = state.time, dt = pendulum_end_time / frames;
            EXPECT_TRUE(method.step(pendulum, dt, state).ok());
            EXPECT_EQ(state.time, before + dt);
        }
        EXPECT_LT(distance(state, pendulum_end[1]), 2e-8) << frames;
        return method.counts().steps;
    };
    const std::size_t steps = run(1);
    for (const int frames : {7, 13, 26}) EXPECT_EQ(run(frames), steps) << frames;
}

// However still it is, a force that begins between two frames is met.
TEST(StepChoice, StepsOverNothingThatBeginsBetweenFrames) {
    const auto late = [](double t, double, double) { return t > 100.0 && t < 100.2 ? 10.0 : 0.0; };
    LineSystem<double> system(late);
    auto method = dopri5(1e-6);
    method.prepare(system);
    ParticleState<double> state = line_state<double>(1, 0.0, 0.0);
    for (int n = 0; n < 30 * 101; ++n) ASSERT_TRUE(method.step(system, 1.0 / 30, state).ok());
    EXPECT_NEAR(state.v[0].x, 2.0, 1e-2);
}

TEST(StepChoice, PutsPinsExactlyWhereTheyAre) {
    LineSystem<double> system(spring, 2, true);
    auto method = dopri5(1e-9);
    method.prepare(system);
    ParticleState<double> state = line_state<double>(2, 0.0, 0.0);
    system.constrain(0.0, state.x.view(), state.v.view());
    for (int n = 0; n < 100; ++n) {
        ASSERT_TRUE(method.step(system, 0.013, state).ok());
        ParticleState<double> there = state;
        system.constrain(state.time, there.x.view(), there.v.view());
        ASSERT_EQ(state.x[0], there.x[0]);
        ASSERT_EQ(state.v[0], there.v[0]);
    }
    // x'' = -25 (x - sin t) from rest: (25 sin t - 5 sin 5 t) / 24.
    const double t = state.time;
    EXPECT_NEAR(state.x[1].x, (25.0 * std::sin(t) - 5.0 * std::sin(5.0 * t)) / 24.0, 1e-7);
}

TEST(StepChoice, GoesBackAndOnToTheSameBits) {
    for (const auto& make : {dopri5<double>, bosh3<double>}) {
        SpringPendulum pendulum(Pendulum::forced);
        auto method = make(1e-7), other = make(1e-7);
        method.prepare(pendulum);
        other.prepare(pendulum);
        ParticleState<double> state = state_of(pendulum_start);
        Integrator<double>::History history;
        method.save(history);  // before the first step there is nothing
        for (int n = 0; n < 9; ++n) method.step(pendulum, 0.03, state);
        ParticleState<double> start = state_of(pendulum_start);
        method.restore(history);
        for (int n = 0; n < 9; ++n) method.step(pendulum, 0.03, start);
        ASSERT_TRUE(same_bits(start, state));

        method.save(history);
        const ParticleState<double> saved = state;
        for (int n = 0; n < 9; ++n) method.step(pendulum, 0.03, state);
        for (auto* again : {&method, &other}) {
            ParticleState<double> repeated = saved;
            again->restore(history);
            Integrator<double>::History twice;
            again->save(twice);  // saved before any step is made again
            again->restore(twice);
            for (int n = 0; n < 9; ++n) again->step(pendulum, 0.03, repeated);
            EXPECT_TRUE(same_bits(repeated, state));
        }
    }
}

TEST(StepChoice, StartsAnewFromTheStateAfterARestart) {
    SpringPendulum pendulum(Pendulum::damped);
    auto method = dopri5(1e-7), fresh = dopri5(1e-7);
    method.prepare(pendulum);
    fresh.prepare(pendulum);
    ParticleState<double> a = state_of(pendulum_start);
    for (int n = 0; n < 5; ++n) method.step(pendulum, 0.03, a);
    a.x.set(0, {0.9, -0.3, 0.2});
    method.restart();
    ParticleState<double> b = a;
    for (int n = 0; n < 5; ++n) {
        method.step(pendulum, 0.03, a);
        fresh.step(pendulum, 0.03, b);
    }
    EXPECT_TRUE(same_bits(a, b));
}

// Falls into a centre that attracts with 1/r^2: from rest at 1 m after pi / (2 sqrt 2) s.
TEST(StepChoice, FailsBeforeASingularityAndLeavesTheState) {
    const auto attraction = [](double, double x, double) { return -1.0 / (x * std::abs(x)); };
    for (const auto& make : {dopri5<double>, bosh3<double>}) {
        LineSystem<double> system(attraction);
        auto method = make(1e-9);
        method.prepare(system);
        ParticleState<double> state = line_state<double>(1, 1.0, 0.0);
        ASSERT_TRUE(method.step(system, 1.0, state).ok());
        const ParticleState<double> before = state;
        const StepReport report = method.step(system, 0.2, state);
        ASSERT_FALSE(report.ok());
        EXPECT_TRUE(same_bits(state, before));
        EXPECT_NE(report.failure->reason.find("at 1.11"), std::string::npos)
            << report.failure->reason;
        EXPECT_NE(report.failure->reason.find("tolerance of 1e-09 m"), std::string::npos);
        EXPECT_NE(report.failure->advice.find("integrator.tolerance"), std::string::npos);
        EXPECT_TRUE(method.step(system, 0.1, state).ok());  // it is well until there
        EXPECT_GT(state.x[0].x, 0.01);
    }
}

TEST(StepChoice, FailsAtAToleranceNoStepMeets) {
    int calls = 0;  // a force without any smoothness, of 1e12 m/s2
    LineSystem<double> system(
        [&](double, double, double) { return ++calls % 2 == 0 ? 1e12 : -1e12; });
    auto method = dopri5(1e-12);
    method.prepare(system);
    ParticleState<double> state = line_state<double>(1, 1.0, 0.0);
    const ParticleState<double> before = state;
    EXPECT_FALSE(method.step(system, 0.1, state).ok());
    EXPECT_TRUE(same_bits(state, before));
}

TEST(StepChoice, FailsWhereAccelerationsAreNotFinite) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        for (const double from : {0.0, 0.25}) {
            LineSystem<double> system(
                [=](double t, double, double) { return t >= from ? bad : -1.0; });
            auto method = dopri5(1e-6);
            method.prepare(system);
            ParticleState<double> state = line_state<double>(1, 1.0, 0.0);
            const ParticleState<double> before = state;
            const StepReport report = method.step(system, 0.5, state);
            ASSERT_FALSE(report.ok());
            EXPECT_TRUE(same_bits(state, before));
        }
    }
}

// A force that acts for 10 ms in 2 s: short steps there, long ones elsewhere.
TEST(StepChoice, TakesFewerEvaluationsThanFixedStepsOnATransient) {
    const auto pulsed = [](double t, double x, double v) {
        const double s = (t - 0.9) / 0.005;
        return -25.0 * x - 0.5 * v + 2e3 * std::exp(-s * s);
    };
    const Slope slope = [&](double t, const Values& y, Values& out) {
        out = {y[1], pulsed(t, y[0], y[1])};
    };
    const Values end = extrapolate(slope, 0.0, 2.0, {1.0, 0.0}, 2000);
    LineSystem<double> system(pulsed);
    auto method = dopri5(1e-7);
    method.prepare(system);
    ParticleState<double> state = line_state<double>(1, 1.0, 0.0);
    for (int n = 0; n < 20; ++n) ASSERT_TRUE(method.step(system, 0.1, state).ok());
    const double error = std::abs(state.x[0].x - end[0]);
    EXPECT_LT(error, 2e-6);

    RungeKutta<double> rk4(classical4_table, InstructionSet::scalar);
    rk4.prepare(system);
    std::size_t evaluations = 0;
    for (int steps = 100; evaluations == 0; steps += steps / 10) {
        state = line_state<double>(1, 1.0, 0.0);
        for (int n = 0; n < steps; ++n) rk4.step(system, 2.0 / steps, state);
        if (std::abs(state.x[0].x - end[0]) < error) {
            evaluations = 4 * static_cast<std::size_t>(steps);
        }
    }
    RecordProperty("dopri5", static_cast<int>(method.counts().evaluations));
    RecordProperty("rk4", static_cast<int>(evaluations));
    EXPECT_LT(3 * method.counts().evaluations, evaluations);
}

// Below what a place in float can hold, the tolerance is that; steps do not shrink for nothing.
TEST(StepChoice, TakesInFloatAFloorOfRounding) {
    const auto run = [](auto real, double tolerance) {
        using Real = decltype(real);
        LineSystem<Real> system(spring);
        auto method = dopri5<Real>(tolerance);
        method.prepare(system);
        ParticleState<Real> state = line_state<Real>(1, 1.0, 0.0);
        for (int n = 0; n < 20; ++n) EXPECT_TRUE(method.step(system, 0.5, state).ok());
        EXPECT_NEAR(static_cast<double>(state.x[0].x), std::cos(50.0), 1e3 * tolerance + 1e-3);
        return method.counts();
    };
    const SolverCounts single = run(float{}, 1e-5), twice = run(double{}, 1e-5);
    EXPECT_NEAR(static_cast<double>(single.steps), static_cast<double>(twice.steps), 5.0);
    const SolverCounts finest = run(float{}, 1e-12);
    EXPECT_LT(finest.steps, 3 * single.steps);
    EXPECT_LT(finest.rejected, finest.steps / 10);
}

TEST(StepChoice, IsTheSameOnAnyThreads) {
    constexpr std::size_t count = 40'001;
    const auto run = [](int threads) {
        ThreadTeam team(threads);
        LineSystem<float> system(
            [](double, double x, double v) { return -25.0 * x * x * x - 0.3 * v; }, count);
        auto method = dopri5<float>(1e-6);
        method.prepare(system);
        ParticleState<float> state = line_state<float>(count, 1.0, 0.5);
        team.run([&] {
            for (int n = 0; n < 5; ++n) EXPECT_TRUE(method.step(system, 0.05, state).ok());
        });
        return state;
    };
    const ParticleState<float> one = run(1);
    for (const int threads : {2, 3, 4}) EXPECT_TRUE(same_bits(run(threads), one)) << threads;
}

}  // namespace
}  // namespace weft::test
