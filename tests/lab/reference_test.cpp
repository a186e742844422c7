// The reference solution against a closed form, against CVODE, and where forces have kinks.
#include "lab/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lab/kinks.h"
#include "lab/order/test_problems.h"
#include "support/cloth_scenes.h"
#include "support/cvode.h"
#include "support/temporary_study.h"

namespace weft::lab {
namespace {

using test::bare_sheet;
using test::no_watch;
using test::Values;

TEST(Reference, FollowsTheHangingMassesToTheLastDigits) {
    Specimen specimen(hanging_masses());
    const Reference found = reference_solution(specimen, specimen.start(), 20.0, 1e-13, no_watch);
    EXPECT_TRUE(found.converged);
    EXPECT_EQ(found.state.time, 20.0);
    EXPECT_LT(rms_distance(specimen.cloth(), found.state, hanging_solution(specimen, 20.0)), 1e-12);
    EXPECT_LT(found.evaluations, 10'000u);
}

TEST(Reference, ErrsNoMoreThanItEstimates) {
    Specimen specimen(hanging_masses());
    for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
        const Reference found =
            reference_solution(specimen, specimen.start(), 20.0, tolerance, no_watch);
        const double error =
            rms_distance(specimen.cloth(), found.state, hanging_solution(specimen, 20.0));
        EXPECT_LE(error, found.error) << tolerance;
        EXPECT_LT(found.error, 200.0 * tolerance);
    }
}

// All x, then all v, of a specimen's slots; pins are where the scene has them.
class SlopeOf {
public:
    explicit SlopeOf(Specimen& specimen)
        : specimen_(specimen), slots_(specimen.cloth().layout.slot_count()), a_(slots_) {}

    Values values(const ParticleState<double>& state) const {
        Values y(6 * slots_);
        for (std::size_t s = 0; s < slots_; ++s) {
            put(y, s, state.x[s]);
            put(y, slots_ + s, state.v[s]);
        }
        return y;
    }

    ParticleState<double> state(double t, const Values& y) const {
        ParticleState<double> state{Vec3Array<double>(slots_), Vec3Array<double>(slots_), t};
        for (std::size_t s = 0; s < slots_; ++s) {
            state.x.set(s, {y[3 * s], y[3 * s + 1], y[3 * s + 2]});
            const std::size_t v = 3 * (slots_ + s);
            state.v.set(s, {y[v], y[v + 1], y[v + 2]});
        }
        specimen_.system().constrain(t, state.x.view(), state.v.view());
        return state;
    }

    void operator()(double t, const Values& y, Values& out) {
        const ParticleState<double> now = state(t, y);
        specimen_.system().acceleration(t, now.x.view(), now.v.view(), a_.view());
        for (std::size_t s = 0; s < slots_; ++s) {
            put(out, s, now.v[s]);
            put(out, slots_ + s, a_[s]);
        }
    }

private:
    static void put(Values& y, std::size_t at, Vec3d value) {
        y[3 * at] = value.x;
        y[3 * at + 1] = value.y;
        y[3 * at + 2] = value.z;
    }

    Specimen& specimen_;
    std::size_t slots_;
    Vec3Array<double> a_;
};

double distance_from_cvode(const SceneDescription& scene, double end) {
    Specimen specimen(scene);
    SlopeOf slope(specimen);
    const Reference found = reference_solution(specimen, specimen.start(), end, 1e-12, no_watch);
    EXPECT_TRUE(found.converged);
    test::Cvode cvode([&](double t, const Values& y, Values& out) { slope(t, y, out); }, 1e-12);
    const Values y = cvode(0.0, end, slope.values(specimen.start()));
    return rms_distance(specimen.cloth(), found.state, slope.state(end, y));
}

TEST(Reference, AgreesWithCvode) {
    EXPECT_LT(distance_from_cvode(moving_sheet(false), moving_end_time), 1e-9);
    EXPECT_LT(distance_from_cvode(moving_sheet(true), moving_end_time), 1e-9);
}

// Gusts drawn anew every 50 ms, and a pin that stops at 0.2 s.
TEST(Reference, AgreesWithCvodeAcrossKinks) {
    SceneDescription scene = moving_sheet(true);
    scene.wind->gust.period = 0.05;
    scene.pins.back().motion.back().time = 0.2;
    EXPECT_LT(distance_from_cvode(scene, 0.31), 1e-8);
}

TEST(Reference, PutsMovingPinsInTheirPlaces) {
    Specimen specimen(moving_sheet(false));
    const Reference found = reference_solution(specimen, specimen.start(), 0.3, 1e-9, no_watch);
    ParticleState<double> put = found.state;
    specimen.system().constrain(0.3, put.x.view(), put.v.view());
    EXPECT_EQ(rms_distance(specimen.cloth(), put, found.state), 0.0);
    EXPECT_GT(length(found.state.v[specimen.cloth().slot(5)]), 0.1);
}

TEST(Reference, StaysWhereNoTimePasses) {
    Specimen specimen(hanging_masses());
    const Reference found = reference_solution(specimen, specimen.start(), 0.0, 1e-9, no_watch);
    EXPECT_TRUE(found.converged);
    EXPECT_EQ(found.steps, 0u);
    EXPECT_EQ(found.error, 0.0);
}

TEST(Reference, SaysWhereItCannotGoOn) {
    Specimen specimen(hanging_masses());
    ParticleState<double> broken = specimen.start();
    broken.v.set(specimen.cloth().slot(4), {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
    const Reference found = reference_solution(specimen, broken, 1.0, 1e-9, no_watch);
    EXPECT_FALSE(found.converged);
    EXPECT_EQ(found.state.time, 0.0);
}

TEST(Reference, EndsWhenItIsTold) {
    Specimen specimen(hanging_masses());
    int calls = 0;
    const Watch stop = [&] {
        if (++calls == 20) throw Interrupted{};
    };
    EXPECT_THROW(reference_solution(specimen, specimen.start(), 100.0, 1e-12, stop), Interrupted);
}

TEST(Kinks, AreDrawsOfGustsAndKeyframes) {
    SceneDescription scene = moving_sheet(true);  // gusts every 5 s, a keyframe at 1 s
    EXPECT_EQ(kinks_between(scene, 0.0, 12.0), (std::vector{1.0, 5.0, 10.0}));
    EXPECT_EQ(kinks_between(scene, 5.0, 10.0), std::vector<double>{});
    scene.wind->gust.model = GustModel::none;
    EXPECT_EQ(kinks_between(scene, 0.0, 12.0), std::vector{1.0});
    EXPECT_EQ(kinks_between(bare_sheet(3, 3), 0.0, 12.0), std::vector<double>{});
}

TEST(SmoothStretch, AvoidsKinks) {
    SceneDescription scene = moving_sheet(true);
    const Stretch none = smooth_stretch(bare_sheet(3, 3), 0.7, 0.5);
    EXPECT_EQ(none.begin, 0.7);
    EXPECT_EQ(none.end, 1.2);
    const Stretch after = smooth_stretch(scene, 0.7, 0.5);  // the keyframe at 1 s is in the way
    EXPECT_NEAR(after.begin, 1.2, 1e-12);
    EXPECT_NEAR(after.length(), 0.5, 1e-12);
    scene.wind->gust.period = 0.1;  // gaps of 0.1 s: 0.09 s of one can be used
    const Stretch within = smooth_stretch(scene, 2.0, 0.5);
    EXPECT_NEAR(within.length(), 0.09, 1e-12);
    EXPECT_TRUE(kinks_between(scene, within.begin, within.end).empty());
}

}  // namespace
}  // namespace weft::lab
