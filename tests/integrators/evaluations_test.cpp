// What a method states of its cost, and what it keeps from step to step.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "support/methods.h"
#include "support/spring_pendulum.h"

namespace weft::test {
namespace {

TEST(Catalogue, HasTheMethodsOfTheTableInTheirOrder) {
    std::vector<std::string_view> names;
    for (const IntegratorInfo& info : integrator_catalogue()) names.push_back(info.name);
    const std::vector<std::string_view> expected{"forward-euler",
                                                 "symplectic-euler",
                                                 "verlet",
                                                 "time-corrected-verlet",
                                                 "velocity-verlet",
                                                 "rk2",
                                                 "rk3",
                                                 "rk4",
                                                 "yoshida4",
                                                 "forest-ruth",
                                                 "bosh3",
                                                 "dopri5",
                                                 "implicit-euler",
                                                 "implicit-midpoint",
                                                 "trapezoidal",
                                                 "bdf2",
                                                 "tr-bdf2",
                                                 "sdirk2",
                                                 "baraff-witkin",
                                                 "projective-dynamics",
                                                 "xpbd",
                                                 "vbd"};
    EXPECT_EQ(names, expected);
}

TEST(Catalogue, FindsEveryMethodByItsNameAndNoOther) {
    for (const IntegratorInfo& info : integrator_catalogue()) {
        EXPECT_EQ(find_integrator(info.name), &info);
        EXPECT_FALSE(info.formula.empty());
        EXPECT_FALSE(info.reference.empty());
        // A step of its own where neither stability nor error gives one.
        const bool free =
            info.kind == IntegratorKind::implicit || info.kind == IntegratorKind::by_springs;
        EXPECT_EQ(info.auto_step > 0.0, free) << info.name;
        EXPECT_EQ(std::isinf(info.imaginary_limit), free) << info.name;
    }
    EXPECT_EQ(find_integrator("rk5"), nullptr);
    EXPECT_EQ(find_integrator(""), nullptr);
    EXPECT_EQ(find_integrator("Verlet"), nullptr);
}

TEST(Evaluations, PerStepAreAsStatedOnceStarted) {
    for (const IntegratorInfo& info : explicit_methods()) {
        SpringPendulum pendulum(Pendulum::free);
        const auto integrator = make_integrator<double>(info.name);
        integrator->prepare(pendulum);
        ParticleState<double> state = state_of(pendulum_start);
        integrator->step(pendulum, 0.01, state);
        EXPECT_LE(pendulum.evaluations, info.evaluations + 1) << info.name;  // one to start
        pendulum.evaluations = 0;
        for (int n = 0; n < 10; ++n) integrator->step(pendulum, 0.01, state);
        EXPECT_EQ(pendulum.evaluations, 10 * info.evaluations) << info.name;
    }
}

// Going back to a saved history and state repeats the run to the bit; so the replay of a frame
// does.
TEST(History, RestoredGivesTheSameBits) {
    for (const IntegratorInfo& info : explicit_methods()) {
        SpringPendulum pendulum(Pendulum::damped);
        const auto integrator = make_integrator<double>(info.name);
        integrator->prepare(pendulum);
        ParticleState<double> state = state_of(pendulum_start);
        for (int n = 0; n < 5; ++n) integrator->step(pendulum, 0.01, state);
        Integrator<double>::History history;
        integrator->save(history);
        const ParticleState<double> saved = state;
        for (int n = 0; n < 3; ++n) integrator->step(pendulum, 0.01, state);
        const ParticleState<double> first = state;
        for (int n = 0; n < 4; ++n) integrator->step(pendulum, 0.02, state);  // led astray
        state = saved;
        integrator->restore(history);
        for (int n = 0; n < 3; ++n) integrator->step(pendulum, 0.01, state);
        EXPECT_EQ(state.x[0], first.x[0]) << info.name;
        EXPECT_EQ(state.v[0], first.v[0]) << info.name;
    }
}

TEST(History, IsForgottenByARestart) {
    for (const IntegratorInfo& info : explicit_methods()) {
        SpringPendulum pendulum(Pendulum::damped);
        const auto used = make_integrator<double>(info.name),
                   fresh = make_integrator<double>(info.name);
        used->prepare(pendulum);
        fresh->prepare(pendulum);
        ParticleState<double> a = state_of(pendulum_start), b = a;
        for (int n = 0; n < 5; ++n) used->step(pendulum, 0.01, a);
        a = b;
        used->restart();
        for (int n = 0; n < 3; ++n) {
            used->step(pendulum, 0.01, a);
            fresh->step(pendulum, 0.01, b);
        }
        EXPECT_EQ(a.x[0], b.x[0]) << info.name;
        EXPECT_EQ(a.v[0], b.v[0]) << info.name;
    }
}

// float and double are one method: they agree to float's rounding.
TEST(Precision, FloatAgreesWithDoubleToItsRounding) {
    struct Falling final : DynamicsSystem<float> {
        [[nodiscard]] std::size_t slot_count() const override { return 1; }
        void acceleration(double t, ConstVec3View<float> x, ConstVec3View<float> v,
                          Vec3View<float> a) override {
            const SpringPendulum pendulum(Pendulum::damped);
            a.set(0, vec3_cast<float>(pendulum.acceleration(t, vec3_cast<double>(x[0]),
                                                            vec3_cast<double>(v[0]))));
        }
        void constrain(double, Vec3View<float>, Vec3View<float>) const override {}
    };
    for (const IntegratorInfo& info : explicit_methods()) {
        SpringPendulum pendulum(Pendulum::damped);
        Falling single;
        const auto a = make_integrator<double>(info.name);
        const auto b = make_integrator<float>(info.name);
        a->prepare(pendulum);
        b->prepare(single);
        ParticleState<double> s = state_of(pendulum_start);
        ParticleState<float> f{Vec3Array<float>(1), Vec3Array<float>(1), 0.0};
        f.x.set(0, vec3_cast<float>(pendulum_start.x));
        f.v.set(0, vec3_cast<float>(pendulum_start.v));
        for (int n = 0; n < 50; ++n) {
            a->step(pendulum, 0.01, s);
            b->step(single, 0.01, f);
        }
        // Position Verlet carries differences of places: their rounding, over dt, adds up.
        const double tolerance = info.name.ends_with("verlet") ? 2e-3 : 2e-5;
        EXPECT_LT(length(s.x[0] - vec3_cast<double>(f.x[0])), tolerance) << info.name;
        EXPECT_LT(length(s.v[0] - vec3_cast<double>(f.v[0])), 10 * tolerance) << info.name;
    }
}

}  // namespace
}  // namespace weft::test
