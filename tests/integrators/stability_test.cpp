// The stability limits that the methods state, against closed forms, and against running them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "integrators/integrator.h"
#include "support/methods.h"

namespace weft::test {
namespace {

constexpr std::array damping_ratios{0.0, 0.01, 0.1, 0.3, 0.7, 1.0, 3.0};

// x'' = -omega^2 x - 2 zeta omega x'.
class Oscillator final : public DynamicsSystem<double> {
public:
    Oscillator(double omega, double zeta) : omega_(omega), zeta_(zeta) {}
    [[nodiscard]] std::size_t slot_count() const override { return 1; }
    void acceleration(double, ConstVec3View<double> x, ConstVec3View<double> v,
                      Vec3View<double> a) override {
        a.set(0, -omega_ * omega_ * x[0] - 2.0 * zeta_ * omega_ * v[0]);
    }
    void constrain(double, Vec3View<double>, Vec3View<double>) const override {}

private:
    double omega_, zeta_;
};

// log of the oscillation's growth over so many steps of the real stepper, after 20 to settle on the
// mode that grows most.
double logarithm_of_growth(std::string_view method, double omega_dt, double zeta, int steps) {
    constexpr double omega = 7.0;  // [1/s]
    Oscillator oscillator(omega, zeta);
    const auto integrator = make_integrator<double>(method);
    integrator->prepare(oscillator);
    ParticleState<double> state{Vec3Array<double>(1), Vec3Array<double>(1), 0.0};
    state.x.set(0, {1.0, 0.0, 0.0});
    state.v.set(0, {0.3 * omega, 0.0, 0.0});
    const auto size = [&] { return std::hypot(state.x[0].x, state.v[0].x / omega); };
    double start = 1.0;
    for (int n = 0; n < steps + 20; ++n) {
        if (n == 20) start = size();
        integrator->step(oscillator, omega_dt / omega, state);
    }
    return std::log(size() / start);
}

// The growth of the real stepper is amplification() to the power of the steps made: at 0.99 of the
// limit it decays (undamped: stays), at 1.01 it blows up.
TEST(SlowStabilityLimit, RunsAt99AndBlowsUpAt101HundredthsOfIt) {
    for (const IntegratorInfo& info : explicit_methods()) {
        for (const double zeta : damping_ratios) {
            const double limit = stability_limit(info.name, zeta);
            if (limit == 0.0) continue;
            for (const double part : {0.99, 1.01}) {
                const double rate = std::log(amplification(info.name, part * limit, zeta));
                const int steps = static_cast<int>(
                    std::clamp(24.0 / std::max(std::abs(rate), 1e-12), 100.0, 1.5e7));
                const int made = std::abs(rate) < 1e-9 ? 10'000 : steps;  // undamped and stable
                const double growth = logarithm_of_growth(info.name, part * limit, zeta, made);
                SCOPED_TRACE(std::string(info.name) + " at damping " + std::to_string(zeta));
                // A defective or a nearly equal second mode costs a few powers of e at first.
                EXPECT_NEAR(growth, rate * made, 5.0);
                if (part > 1.0) {
                    EXPECT_GT(growth, 15.0);
                } else if (zeta > 0.0) {
                    EXPECT_LT(growth, -15.0);
                }
            }
        }
    }
}

TEST(StabilityLimit, WithoutDampingIsTheStatedOne) {
    for (const IntegratorInfo& info : explicit_methods()) {
        EXPECT_NEAR(stability_limit(info.name, 0.0), info.imaginary_limit, 1e-4) << info.name;
    }
    EXPECT_NEAR(stability_limit("verlet", 0.0), 2.0, 1e-6);
    EXPECT_NEAR(stability_limit("rk3", 0.0), std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(stability_limit("rk4", 0.0), 2.0 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(stability_limit("yoshida4", 0.0), 1.5734, 5e-5);
}

// Undamped, forward Euler grows by sqrt(1 + y^2) a step and the midpoint rule by sqrt(1 + y^4/4),
// however short the step.
TEST(StabilityLimit, IsNoneForForwardEulerAndMidpointWithoutDamping) {
    for (const double y : {0.01, 0.1, 0.5}) {
        EXPECT_NEAR(amplification("forward-euler", y, 0.0), std::sqrt(1 + y * y), 1e-15);
        EXPECT_NEAR(amplification("rk2", y, 0.0), std::sqrt(1 + std::pow(y, 4) / 4), 1e-15);
        EXPECT_NEAR(logarithm_of_growth("forward-euler", y, 0.0, 1000), 500 * std::log1p(y * y),
                    1e-9);
        EXPECT_NEAR(logarithm_of_growth("rk2", y, 0.0, 1000), 500 * std::log1p(std::pow(y, 4) / 4),
                    1e-9);
    }
    EXPECT_EQ(stability_limit("forward-euler", 0.0), 0.0);
    EXPECT_EQ(stability_limit("rk2", 0.0), 0.0);
}

// Forward Euler: 2 zeta while underdamped, then 2 / (zeta + sqrt(zeta^2 - 1)).
TEST(StabilityLimit, OfForwardEulerIsItsClosedForm) {
    for (const double zeta : {0.01, 0.1, 0.3, 0.7, 1.0, 3.0, 20.0}) {
        const double expected = zeta <= 1 ? 2 * zeta : 2 / (zeta + std::sqrt(zeta * zeta - 1));
        EXPECT_NEAR(stability_limit("forward-euler", zeta), expected, 1e-8 * expected) << zeta;
    }
}

// With the velocity before the kick: 2 (sqrt(1 + zeta^2) - zeta). The Verlets, whose damping lags
// by up to a step, behave as if damped twice as much.
TEST(StabilityLimit, OfSymplecticEulerAndTheVerletsAreTheirClosedForms) {
    const auto closed_form = [](double z) { return 2 * (std::sqrt(1 + z * z) - z); };
    for (const double zeta : {0.01, 0.1, 0.3, 0.7, 1.0, 3.0, 20.0}) {
        EXPECT_NEAR(stability_limit("symplectic-euler", zeta), closed_form(zeta), 1e-8) << zeta;
        for (const auto* method : {"verlet", "time-corrected-verlet", "velocity-verlet"}) {
            EXPECT_NEAR(stability_limit(method, zeta), closed_form(2 * zeta), 1e-8)
                << method << " " << zeta;
        }
    }
}

// Runge-Kutta methods of order p in p stages grow as the exponential's series to z^p.
TEST(Amplification, OfRungeKuttaIsTheExponentialSeries) {
    const std::array<const char*, 4> methods{"forward-euler", "rk2", "rk3", "rk4"};
    for (std::size_t order = 1; order <= methods.size(); ++order) {
        for (const double zeta : damping_ratios) {
            for (double y = 0.05; y < 3.5; y += 0.05) {
                double largest = 0.0;
                for (const double sign : {1.0, -1.0}) {
                    const auto z = y * (-zeta + sign * std::sqrt(std::complex(zeta * zeta - 1.0)));
                    std::complex<double> series = 1.0, term = 1.0;
                    for (std::size_t n = 1; n <= order; ++n) {
                        term *= z / static_cast<double>(n);
                        series += term;
                    }
                    largest = std::max(largest, std::abs(series));
                }
                EXPECT_NEAR(amplification(methods[order - 1], y, zeta), largest, 1e-12 * largest)
                    << methods[order - 1] << " " << zeta << " " << y;
            }
        }
    }
}

// Below the limit every step is stable, not only those near it.
TEST(StabilityLimit, HasNoUnstableStepBelowIt) {
    for (const IntegratorInfo& info : explicit_methods()) {
        for (const double zeta : damping_ratios) {
            const double limit = stability_limit(info.name, zeta);
            for (int n = 1; n < 1000; ++n) {
                ASSERT_LT(amplification(info.name, limit * n / 1000, zeta), 1 + 1e-9)
                    << info.name << " " << zeta;
            }
            if (limit == 0.0) continue;
            EXPECT_GT(amplification(info.name, 1.0001 * limit, zeta), 1 + 1e-12)
                << info.name << " " << zeta;
        }
    }
}

}  // namespace
}  // namespace weft::test
