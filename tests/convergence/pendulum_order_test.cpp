// Every integrator reaches the order it states, measured in double on a nonlinear spring pendulum
// against 60-digit references, at an end time that is no multiple of a period.
#include <gtest/gtest.h>

#include "support/extrapolation.h"
#include "support/methods.h"
#include "support/order_fit.h"
#include "support/spring_pendulum.h"

namespace weft::test {
namespace {

// Methods that take the step they are given, on a system that is no list of springs.
std::vector<IntegratorInfo> methods() {
    return methods_of({IntegratorKind::explicit_steps, IntegratorKind::implicit});
}

std::unique_ptr<Integrator<double>> make_tight(std::string_view method) {
    IntegratorSettings settings;
    settings.tolerance = 1e-13;  // of implicit stages [m]
    return make_integrator<double>(method, settings);
}

double error_after(std::string_view method, Pendulum kind, int steps) {
    SpringPendulum pendulum(kind);
    const auto integrator = make_tight(method);
    integrator->prepare(pendulum);
    ParticleState<double> state = state_of(pendulum_start);
    for (int n = 0; n < steps; ++n) integrator->step(pendulum, pendulum_end_time / steps, state);
    EXPECT_NEAR(state.time, pendulum_end_time, 1e-11);
    return distance(state, pendulum_end[static_cast<std::size_t>(kind)]);
}

// Steps between the coarsest that shows the order and rounding; first order needs short ones.
double measured_order(std::string_view method, Pendulum kind, int stated) {
    const int first = stated == 1 ? 2048 : stated == 2 ? 256 : 128;
    std::vector<ErrorAtStep> errors;
    for (int steps = first; steps <= 16 * first; steps *= 2) {
        errors.push_back({pendulum_end_time / steps, error_after(method, kind, steps)});
    }
    return fitted_order(errors);
}

constexpr double tolerance = 0.1;

TEST(PendulumOrder, IsAsStatedWithoutDamping) {
    for (const IntegratorInfo& info : methods()) {
        EXPECT_NEAR(measured_order(info.name, Pendulum::free, info.order), info.order, tolerance)
            << info.name;
    }
}

TEST(PendulumOrder, IsAsStatedWithDashpotAndDrag) {
    for (const IntegratorInfo& info : methods()) {
        EXPECT_NEAR(measured_order(info.name, Pendulum::damped, info.damped_order),
                    info.damped_order, tolerance)
            << info.name;
    }
}

TEST(PendulumOrder, IsAsStatedWithForcesThatChangeInTime) {
    for (const IntegratorInfo& info : methods()) {
        EXPECT_NEAR(measured_order(info.name, Pendulum::forced, info.order), info.order, tolerance)
            << info.name;
    }
}

// The reference solver of the other tests, held against the same digits.
TEST(PendulumOrder, ReferenceSolverAgreesWithTheReference) {
    for (const Pendulum kind : {Pendulum::free, Pendulum::damped, Pendulum::forced}) {
        const SpringPendulum pendulum(kind);
        const Slope slope = [&](double t, const Values& y, Values& out) {
            const Vec3d a = pendulum.acceleration(t, {y[0], y[1], y[2]}, {y[3], y[4], y[5]});
            out = {y[3], y[4], y[5], a.x, a.y, a.z};
        };
        const auto [x, v] = pendulum_start;
        const Values y =
            extrapolate(slope, 0.0, pendulum_end_time, {x.x, x.y, x.z, v.x, v.y, v.z}, 200);
        const PointState end = pendulum_end[static_cast<std::size_t>(kind)];
        EXPECT_LT(length(Vec3d{y[0], y[1], y[2]} - end.x), 1e-12);
        EXPECT_LT(length(Vec3d{y[3], y[4], y[5]} - end.v), 1e-12);
    }
}

// One step from exact values errs by O(dt^(p+1)). The start of both Verlets included.
TEST(PendulumOrder, OneStepErrsByOneOrderMore) {
    const SpringPendulum exact(Pendulum::free);
    const Slope slope = [&](double t, const Values& y, Values& out) {
        const Vec3d a = exact.acceleration(t, {y[0], y[1], y[2]}, {});
        out = {y[3], y[4], y[5], a.x, a.y, a.z};
    };
    const auto [x, v] = pendulum_start;
    for (const IntegratorInfo& info : methods()) {
        std::vector<ErrorAtStep> errors;
        for (double dt = info.order == 4 ? 0.04 : 0.01; errors.size() < 5; dt /= 2) {
            SpringPendulum pendulum(Pendulum::free);
            const auto integrator = make_tight(info.name);
            integrator->prepare(pendulum);
            ParticleState<double> state = state_of(pendulum_start);
            integrator->step(pendulum, dt, state);
            const Values y = extrapolate(slope, 0.0, dt, {x.x, x.y, x.z, v.x, v.y, v.z}, 1);
            errors.push_back({dt, distance(state, {{y[0], y[1], y[2]}, {y[3], y[4], y[5]}})});
        }
        EXPECT_NEAR(fitted_order(errors), info.order + 1, 0.15) << info.name;
    }
}

}  // namespace
}  // namespace weft::test
