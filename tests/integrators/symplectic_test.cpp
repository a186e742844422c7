// Symplectic or not: the one-step map's Jacobian J in (x, v), by central differences on a nonlinear
// conservative system, satisfies J^T Omega J = Omega; and the energy over a long time.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "support/methods.h"
#include "support/spring_pendulum.h"

namespace weft::test {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Vector6 one_step(std::string_view method, double dt, const Vector6& y) {
    SpringPendulum pendulum(Pendulum::free);
    const auto integrator = make_integrator<double>(method);
    integrator->prepare(pendulum);
    ParticleState<double> state = state_of({{y(0), y(1), y(2)}, {y(3), y(4), y(5)}});
    integrator->step(pendulum, dt, state);
    const Vec3d x = state.x[0], v = state.v[0];
    return Vector6{x.x, x.y, x.z, v.x, v.y, v.z};
}

double symplectic_defect(std::string_view method, double dt) {
    Vector6 start{1.1, -0.4, 0.3, 0.7, -0.5, 1.2};
    Matrix6 jacobian;
    constexpr double shift = 1e-5;
    for (int n = 0; n < 6; ++n) {
        const Vector6 e = shift * Vector6::Unit(n);
        jacobian.col(n) =
            (one_step(method, dt, start + e) - one_step(method, dt, start - e)) / (2 * shift);
    }
    Matrix6 omega = Matrix6::Zero();
    omega.topRightCorner<3, 3>().setIdentity();
    omega.bottomLeftCorner<3, 3>() = -Eigen::Matrix3d::Identity();
    return (jacobian.transpose() * omega * jacobian - omega).cwiseAbs().maxCoeff();
}

TEST(Symplectic, OneStepKeepsTheAreaExactlyWhereItIsStated) {
    for (const IntegratorInfo& info : explicit_methods()) {
        const double defect = symplectic_defect(info.name, 0.2);  // omega dt = 1
        if (info.symplectic) {
            EXPECT_LT(defect, 1e-8) << info.name;
        } else {
            EXPECT_GT(defect, 1e-3) << info.name;
        }
    }
}

double energy_of(const ParticleState<double>& state) {
    const Vec3d x = state.x[0], v = state.v[0];
    const double stretch = length(x) - 1.0;
    return 0.5 * dot(v, v) + 12.5 * stretch * stretch + 9.81 * x.y;
}

struct Drift {
    double largest_first = 0.0;  ///< error of the energy over the first hundredth of the run [J]
    double largest_last = 0.0;   ///< the same over the last
};

// The spring's period is 1.26 s.
Drift energy_drift(std::string_view method, double dt, int steps) {
    SpringPendulum pendulum(Pendulum::free);
    const auto integrator = make_integrator<double>(method);
    integrator->prepare(pendulum);
    ParticleState<double> state = state_of(pendulum_start);
    const double start = energy_of(state);
    Drift drift;
    for (int n = 0; n < steps; ++n) {
        integrator->step(pendulum, dt, state);
        const double error = std::abs(energy_of(state) - start);
        if (n < steps / 100) drift.largest_first = std::max(drift.largest_first, error);
        if (n >= steps - steps / 100) drift.largest_last = std::max(drift.largest_last, error);
    }
    return drift;
}

// Over 1e5 periods the error of the energy stays what it was over the first thousand.
TEST(SlowEnergyDrift, IsBoundedOver100000PeriodsWhereSymplectic) {
    constexpr double dt = 0.04;       // omega dt = 0.2
    constexpr int steps = 3'141'593;  // 1e5 periods of 2 pi / 5 s
    for (const IntegratorInfo& info : explicit_methods()) {
        if (!info.symplectic) continue;
        const Drift drift = energy_drift(info.name, dt, steps);
        EXPECT_GT(drift.largest_first, 1e-5) << info.name;
        EXPECT_LT(drift.largest_first, info.order == 1 ? 3.0 : 0.5) << info.name;
        EXPECT_LT(drift.largest_last, 1.1 * drift.largest_first) << info.name;
    }
}

// The Runge-Kutta methods gain or lose energy steadily: ten times the time, about ten times the
// error.
TEST(SlowEnergyDrift, GrowsInTimeWhereNotSymplectic) {
    for (const IntegratorInfo& info : explicit_methods()) {
        if (info.symplectic) continue;
        const double dt = info.order == 1 ? 2e-5 : info.order == 2 ? 5e-3 : 0.02;
        const auto steps = static_cast<int>(20.0 / dt);
        const double one = energy_drift(info.name, dt, steps).largest_last;
        const double ten = energy_drift(info.name, dt, 10 * steps).largest_last;
        EXPECT_GT(ten / one, 5.0) << info.name;
        EXPECT_LT(ten / one, 20.0) << info.name;
    }
}

}  // namespace
}  // namespace weft::test
