// Limits that flights show against those that are predicted, and the experiment made of them.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "lab/experiment.h"
#include "lab/stability/resting_cloth.h"
#include "support/cloth_scenes.h"
#include "support/mesh_scenes.h"
#include "support/sections.h"
#include "support/temporary_study.h"
#include "weft/integrators.h"

namespace weft::lab {
namespace {

using test::add_dashpots;
using test::bare_sheet;
using test::no_watch;
using test::quick_study;
using test::table_of;
using test::TemporaryStudy;

// Predicted and observed limits within 0.5 % for every explicit method that has one.
void expect_limits_as_predicted(const SceneDescription& scene) {
    RestingCloth cloth(scene);
    for (const IntegratorInfo& info : integrator_catalogue()) {
        if (info.kind != IntegratorKind::explicit_steps) continue;
        const double predicted = cloth.modes().stable_step(info.name);
        if (!(predicted > 0.0)) continue;
        const Search search = cloth.plan_search(info.name, predicted, 2e4);
        const ObservedLimit limit = cloth.observe(info.name, predicted, search, no_watch);
        EXPECT_TRUE(limit.found) << info.name;
        EXPECT_NEAR(limit.middle() / predicted, 1.0, 0.005) << info.name;
        EXPECT_LE(limit.unstable / limit.stable, 1.0 + search.resolution) << info.name;
    }
}

TEST(RestingCloth, ObservesThePredictedLimitOfAnUndampedGrid) {
    SceneDescription scene = bare_sheet(8, 6, 1.0, 0.6);
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    scene.forces.gravity = {0.0, -9.81, 0.0};
    expect_limits_as_predicted(scene);
}

TEST(RestingCloth, ObservesThePredictedLimitOfADampedMesh) {
    SceneDescription scene = test::mesh_scene(test::tube_mesh(9, 5, 0.1));
    add_dashpots(scene, 2e-3);
    expect_limits_as_predicted(scene);
}

// The bisection finds the limit, not the prediction: a wrong one is not confirmed.
TEST(RestingCloth, FindsTheLimitFromAWrongPrediction) {
    RestingCloth cloth(bare_sheet(6, 6));
    const double limit = cloth.modes().stable_step("velocity-verlet");
    for (const double part : {0.6, 1.7}) {
        const ObservedLimit found =
            cloth.observe("velocity-verlet", part * limit, {400, 0.004, 1.0}, no_watch);
        EXPECT_TRUE(found.found);
        EXPECT_NEAR(found.middle(), limit, 0.004 * limit) << part;
    }
}

TEST(RestingCloth, FindsNoLimitWhereThereIsNone) {
    RestingCloth cloth(bare_sheet(3, 3), 1e-6);
    const double step = 10.0 * cloth.modes().stable_step("velocity-verlet");
    EXPECT_FALSE(cloth.observe("implicit-euler", step, {10, 0.01, 1.0}, no_watch).found);
}

TEST(RestingCloth, GrowsAsPredictedBeyondTheLimit) {
    RestingCloth cloth(bare_sheet(6, 6));
    for (const char* method : {"velocity-verlet", "rk4", "yoshida4"}) {
        const double step = 1.05 * cloth.modes().stable_step(method);
        const Growth growth = cloth.fly(method, step, 400, no_watch);
        const double expected = cloth.predicted_rate(method, step);
        EXPECT_NEAR(growth.rate, expected, 0.02 * expected) << method;
        EXPECT_GT(growth.total, std::log(1e4)) << method;
    }
    // Forward Euler grows by half of (omega dt)^2 a step, however short it is.
    const double step = 0.1 / cloth.omega();
    EXPECT_NEAR(cloth.fly("forward-euler", step, 3000, no_watch).rate, 0.5 * std::log1p(0.01),
                2e-4);
}

// A free sheet drifts without a spring to hold it, and out of its plane: that is no growth.
TEST(RestingCloth, DoesNotTakeDriftForGrowth) {
    RestingCloth cloth(bare_sheet(6, 6));
    const double step = 0.5 * cloth.modes().stable_step("velocity-verlet");
    const Growth growth = cloth.fly("velocity-verlet", step, 20'000, no_watch);
    EXPECT_NEAR(growth.total, 0.0, 0.2);
    EXPECT_NEAR(growth.rate, 0.0, 1e-6);
}

SceneDescription hanging_sheet() {
    SceneDescription scene = bare_sheet(6, 5);
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.pins = {{EdgeSelection::top_edge, {}}};
    return scene;
}

TEST(StabilityExperiment, HasARowForEveryMethod) {
    TemporaryStudy study(hanging_sheet(), quick_study());
    const Section section = measure_stability(study.laboratory());
    EXPECT_TRUE(section.skipped.empty());
    const Table& limits = table_of(section, "limits");
    ASSERT_EQ(limits.rows.size(), integrator_catalogue().size());
    for (std::size_t n = 0; n < limits.rows.size(); ++n) {
        const IntegratorInfo& info = integrator_catalogue()[n];
        ASSERT_EQ(limits.rows[n].size(), limits.columns.size());
        EXPECT_EQ(std::get<std::string>(limits.rows[n][0]), info.name);
        if (info.kind != IntegratorKind::explicit_steps || info.imaginary_limit == 0.0) {
            EXPECT_FALSE(std::get<std::string>(limits.rows[n].back()).empty()) << info.name;
        } else {
            EXPECT_NEAR(std::get<double>(limits.rows[n][3]), 1.0, 0.01) << info.name;
        }
    }
    EXPECT_EQ(table_of(section, "beyond").rows.size(), 20u);  // ten methods at two steps
    EXPECT_NE(section.answer.find("forward-euler and rk2 are stable at no step"), std::string::npos)
        << section.answer;
    std::set<std::string> ids;
    for (const Block& block : section.blocks) {
        if (const auto* plot = std::get_if<Plot>(&block)) {
            EXPECT_TRUE(ids.insert(plot->id).second);
            EXPECT_FALSE(plot->text.empty());
        }
    }
    EXPECT_EQ(ids,
              (std::set<std::string>{"growth", "regions", "implicit-damped", "implicit-undamped"}));
}

// On one thread or two, and from what is kept: the same numbers.
TEST(StabilityExperiment, GivesTheSameNumbersAgain) {
    TemporaryStudy first(hanging_sheet(), quick_study({"rk4", "xpbd"}, 1)),
        second(hanging_sheet(), quick_study({"rk4", "xpbd"}, 2));
    const Section a = measure_stability(first.laboratory()),
                  b = measure_stability(second.laboratory()),
                  kept = measure_stability(second.laboratory());
    for (const Section* other : {&b, &kept}) {
        EXPECT_EQ(table_of(a, "limits").rows, table_of(*other, "limits").rows);
        EXPECT_EQ(table_of(a, "beyond").rows, table_of(*other, "beyond").rows);
        EXPECT_EQ(a.answer, other->answer);
    }
    EXPECT_EQ(table_of(a, "limits").rows.size(), 2u);
}

TEST(StabilityExperiment, HasNothingToSayWithoutSprings) {
    SceneDescription scene = hanging_sheet();
    scene.material.structural = scene.material.shear = scene.material.bend = {};
    TemporaryStudy study(scene, quick_study());
    EXPECT_FALSE(measure_stability(study.laboratory()).skipped.empty());
}

TEST(StabilityExperiment, SaysSoWhereAdaptiveMethodsAloneAreAskedFor) {
    TemporaryStudy study(hanging_sheet(), quick_study({"dopri5"}));
    const Section section = measure_stability(study.laboratory());
    EXPECT_NE(section.answer.find("no limit"), std::string::npos) << section.answer;
    EXPECT_EQ(table_of(section, "limits").rows.size(), 1u);
}

}  // namespace
}  // namespace weft::lab
