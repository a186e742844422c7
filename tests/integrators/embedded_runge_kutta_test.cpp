// The embedded pairs: orders of both methods and of what lies between steps, tables, step limits.
// How they choose their steps is in step_choice_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "integrators/embedded_runge_kutta.h"
#include "support/extrapolation.h"
#include "support/order_fit.h"
#include "support/spring_pendulum.h"

namespace weft::test {
namespace {

constexpr double anything_goes = 1e9;  // a tolerance [m]

struct Pair {
    const char* name;
    const EmbeddedTable* table;
    int order;
    double imaginary_limit;  // largest omega dt that does not grow, undamped
};
const Pair dopri5{"dopri5", &dopri5_table, 5, 0.9972},
    bosh3{"bosh3", &bosh3_table, 3, std::numbers::sqrt3};

EmbeddedRungeKutta<double> make(const Pair& pair, double tolerance,
                                double largest_step = ErrorControl{}.largest_step) {
    return {*pair.table, {tolerance, largest_step}, InstructionSet::scalar};
}

double fixed_step_order(const ButcherTable& table, Pendulum kind, int first) {
    std::vector<ErrorAtStep> errors;
    for (int steps = first; steps <= 8 * first; steps *= 2) {
        SpringPendulum pendulum(kind);
        RungeKutta<double> method(table, InstructionSet::scalar);
        method.prepare(pendulum);
        ParticleState<double> state = state_of(pendulum_start);
        const double h = pendulum_end_time / steps;
        for (int n = 0; n < steps; ++n) method.step(pendulum, h, state);
        errors.push_back({h, distance(state, pendulum_end[static_cast<std::size_t>(kind)])});
    }
    return fitted_order(errors);
}

class EmbeddedPair : public ::testing::TestWithParam<const Pair*> {
protected:
    const Pair& pair_ = *GetParam();
};

TEST_P(EmbeddedPair, HasItsOrderAtFixedSteps) {
    for (const Pendulum kind : {Pendulum::free, Pendulum::damped, Pendulum::forced}) {
        EXPECT_NEAR(fixed_step_order(pair_.table->method, kind, 40), pair_.order, 0.15);
    }
}

TEST_P(EmbeddedPair, ComparesWithAMethodOfOneOrderLess) {
    ButcherTable lower = pair_.table->method;
    for (std::size_t i = 0; i < lower.b.size(); ++i) lower.b[i] -= pair_.table->error[i];
    for (const Pendulum kind : {Pendulum::free, Pendulum::damped, Pendulum::forced}) {
        EXPECT_NEAR(fixed_step_order(lower, kind, 150), pair_.order - 1, 0.15);
    }
    EXPECT_EQ(pair_.table->error_order, pair_.order);  // a step's error: one order more
}

// No error counts, every step is the longest allowed: the method at a fixed step.
TEST_P(EmbeddedPair, AtAFixedStepIsTheTableThatRungeKuttaRuns) {
    SpringPendulum pendulum(Pendulum::damped);
    auto method = make(pair_, anything_goes, 0.01);
    RungeKutta<double> fixed(pair_.table->method, InstructionSet::scalar);
    method.prepare(pendulum);
    fixed.prepare(pendulum);
    ParticleState<double> a = state_of(pendulum_start), b = a;
    ASSERT_TRUE(method.step(pendulum, 0.5, a).ok());
    for (int n = 0; n < 50; ++n) fixed.step(pendulum, 0.01, b);
    EXPECT_LT(length(a.x[0] - b.x[0]) + length(a.v[0] - b.v[0]), 1e-13);
}

TEST_P(EmbeddedPair, LastStageIsTheEndOfTheStep) {
    const ButcherTable& method = pair_.table->method;
    const auto last = static_cast<std::size_t>(method.stages) - 1;
    EXPECT_EQ(method.a[last], method.b);
    EXPECT_EQ(method.c[last], 1.0);
    for (std::size_t i = 0; i <= last; ++i) {
        double sum = 0.0;
        for (const double a : method.a[i]) sum += a;
        EXPECT_NEAR(sum, method.c[i], 1e-15);
    }
}

TEST_P(EmbeddedPair, GrowsBeyondItsStabilityLimitOnly) {
    const double limit = pair_.imaginary_limit;
    EXPECT_LE(embedded_amplification(*pair_.table, 0.999 * limit, 0.0), 1.0);
    EXPECT_GT(embedded_amplification(*pair_.table, 1.001 * limit, 0.0), 1.0);
}

// One step and a part theta of the next, so that the error is that of the interpolation: order p
// has h^(p+1).
TEST_P(EmbeddedPair, HasItsDenseOrderBetweenSteps) {
    const int dense_order = pair_.order == 5 ? 4 : 3;
    SpringPendulum pendulum(Pendulum::free);
    const Slope slope = [&](double t, const Values& y, Values& out) {
        const Vec3d a = pendulum.acceleration(t, {y[0], y[1], y[2]}, {y[3], y[4], y[5]});
        out = {y[3], y[4], y[5], a.x, a.y, a.z};
    };
    const Vec3d x0 = pendulum_start.x, v0 = pendulum_start.v;
    std::vector<ErrorAtStep> errors;
    for (double h = 0.04; h > 0.002; h /= 2) {
        double largest = 0.0;
        for (const double theta : {0.2, 0.4, 0.6, 0.8}) {
            const double end = (1.0 + theta) * h;
            const Values y = extrapolate(slope, 0.0, end, {x0.x, x0.y, x0.z, v0.x, v0.y, v0.z}, 4);
            auto method = make(pair_, anything_goes, h);
            method.prepare(pendulum);
            ParticleState<double> state = state_of(pendulum_start);
            ASSERT_TRUE(method.step(pendulum, end, state).ok());
            ASSERT_EQ(method.counts().steps, 2u);
            const PointState exact{{y[0], y[1], y[2]}, {y[3], y[4], y[5]}};
            largest = std::max(largest, distance(state, exact));
        }
        errors.push_back({h, largest});
    }
    EXPECT_NEAR(fitted_order(errors), dense_order + 1, 0.25);
}

TEST_P(EmbeddedPair, HasAnErrorInProportionToTheTolerance) {
    for (const Pendulum kind : {Pendulum::free, Pendulum::damped, Pendulum::forced}) {
        std::vector<ErrorAtStep> errors;
        for (double tolerance = 1e-5; tolerance > 0.9e-10; tolerance /= std::sqrt(10.0)) {
            SpringPendulum pendulum(kind);
            auto method = make(pair_, tolerance);
            method.prepare(pendulum);
            ParticleState<double> state = state_of(pendulum_start);
            ASSERT_TRUE(method.step(pendulum, pendulum_end_time, state).ok());
            errors.push_back(
                {tolerance, distance(state, pendulum_end[static_cast<std::size_t>(kind)])});
        }
        EXPECT_NEAR(fitted_order(errors), 1.0, 0.15);
        EXPECT_LT(errors.front().error, 100 * errors.front().step);
    }
}

// The last acceleration is the next step's first; two evaluations choose the first step.
TEST_P(EmbeddedPair, EvaluatesTheForcesOnceLessThanItHasStages) {
    SpringPendulum pendulum(Pendulum::damped);
    auto method = make(pair_, 1e-8);
    method.prepare(pendulum);
    ParticleState<double> state = state_of(pendulum_start);
    for (int n = 0; n < 30; ++n) ASSERT_TRUE(method.step(pendulum, 0.04, state).ok());
    const SolverCounts counts = method.counts();
    const auto stages = static_cast<std::size_t>(pair_.table->method.stages);
    EXPECT_EQ(counts.evaluations, 2 + (stages - 1) * (counts.steps + counts.rejected));
    EXPECT_EQ(counts.evaluations, static_cast<std::size_t>(pendulum.evaluations));
    EXPECT_GE(counts.steps, 30u);
}

TEST_P(EmbeddedPair, TakesNoStepLongerThanTheUserAllows) {
    SpringPendulum pendulum(Pendulum::free);
    auto method = make(pair_, anything_goes, 0.0125);
    method.prepare(pendulum);
    ParticleState<double> state = state_of(pendulum_start);
    ASSERT_TRUE(method.step(pendulum, 0.99, state).ok());
    EXPECT_EQ(method.counts().steps, 80u);  // of 0.0125 s: up to 1 s
    EXPECT_EQ(method.counts().rejected, 0u);
}

INSTANTIATE_TEST_SUITE_P(, EmbeddedPair, ::testing::Values(&dopri5, &bosh3),
                         [](const auto& test) { return test.param->name; });

}  // namespace
}  // namespace weft::test
