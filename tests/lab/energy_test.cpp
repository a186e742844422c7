// Energy accounts of flights, and what the experiment says of the methods.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lab/energy/energy_answer.h"
#include "lab/energy/energy_leg.h"
#include "lab/experiment.h"
#include "support/cloth_scenes.h"
#include "support/temporary_study.h"

namespace weft::lab {
namespace {

using test::add_dashpots;
using test::bare_sheet;
using test::quick_study;
using test::TemporaryStudy;

SceneDescription swinging_sheet() {
    SceneDescription scene = bare_sheet(6, 5, 0.5, 0.4);
    scene.cloth.grid.plane = Plane::xz;
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    scene.output.duration = 2.0;
    return scene;
}

EnergyRun fly(const SceneDescription& scene, const EnergyPlan& plan) {
    return energy_run_from_json(energy_trial(scene, plan, "test").measure([] {}));
}

// A flight whose E - W is account(t), `count` samples of 0.1 s.
template <typename Account>
EnergyRun made_up(std::size_t count, const Account& account) {
    EnergyRun run;
    for (std::size_t n = 0; n <= count; ++n) {
        const double t = 0.1 * static_cast<double>(n);
        run.samples.push_back({t, account(t), 0.0, 0.0, 0.0});
    }
    run.steps = count;
    return run;
}

TEST(EnergyTrend, IsTheSlopeOfAStraightLine) {
    const EnergyRun run = made_up(400, [](double t) { return 5.0 - 0.3 * t; });
    const EnergyTrend trend = energy_trend(run, 10.0, 1e9);
    EXPECT_NEAR(trend.slope, -0.3, 1e-12);
    EXPECT_NEAR(trend.error, 0.0, 1e-12);
    EXPECT_NEAR(trend.from, 10.0, 1e-12);
    EXPECT_NEAR(trend.to, 40.0, 1e-12);
    EXPECT_TRUE(trend.is_sure());
    EXPECT_NEAR(energy_trend(run, 0.0, 6.0).to, 20.0, 1e-9);  // as far as it changed by 6
}

TEST(EnergyTrend, OfASwingIsNotSure) {
    const auto swing = [](double t) { return std::sin(2.0 * std::numbers::pi * t / 0.77); };
    EXPECT_FALSE(energy_trend(made_up(400, swing), 0.0, 1e9).is_sure());
    EXPECT_TRUE(energy_trend(made_up(400, [&](double t) { return swing(t) + 0.05 * t; }), 0.0, 1e9)
                    .is_sure());
}

TEST(EnergyLeg, SaysWhoKeepsLosesAndGains) {
    EnergyLeg leg;
    leg.time_step = 0.1;
    const EnergyScale scale{0.2, 10.0};
    const auto verdict = [&](double slope, std::size_t count) {
        leg.run = made_up(count, [&](double t) { return slope * t; });
        return leg.verdict(scale);
    };
    EXPECT_EQ(verdict(1e-4, 400), Verdict::keeps);  // 2e-6 a period
    EXPECT_EQ(verdict(1e-2, 400), Verdict::gains);  // 2e-4
    EXPECT_EQ(verdict(-1e-2, 400), Verdict::loses);
    EXPECT_EQ(verdict(-1e-2, 15), Verdict::too_short);  // 7.5 periods
    EXPECT_EQ(verdict(5.0, 60), Verdict::gains);        // beyond the motion's energy
    EXPECT_NEAR(leg.drift(scale), 5.0 * 0.2 / 10.0, 1e-12);
    EXPECT_NEAR(leg.largest_change(), 30.0, 1e-9);
}

TEST(EnergyAnswer, TellsEveryMethodOnce) {
    const EnergyScale scale{0.2, 10.0};
    const auto leg = [](const char* method, double slope, std::string failure) {
        EnergyLeg made;
        made.info = find_integrator(method);
        made.time_step = 0.1;
        made.run = made_up(400, [&](double t) { return slope * t; });
        made.run.failure = std::move(failure);
        return made;
    };
    const EnergyLeg keeps = leg("verlet", 1e-5, ""), loses = leg("rk3", -0.01, ""),
                    loses_more = leg("rk4", -0.02, ""), blows_up = leg("rk2", 50.0, "blew up"),
                    fails = leg("bdf2", -0.01, "Newton did not converge");
    EXPECT_EQ(energy_answer({&keeps, &loses, &loses_more, &blows_up, &fails}, scale, "Here"),
              "Here and over 200 to 200 periods of the fastest mode: verlet keeps the energy "
              "(within 1 % in 1000 periods); rk3, rk4 lose energy, 0.0002 to 0.0004 of the "
              "motion's a period; rk2 gains energy until the cloth blows up; bdf2 fails before the "
              "end of the flight.");
}

TEST(EnergyAccount, IsConservedByAnExactFlightWhateverTakesEnergy) {
    SceneDescription scene = swinging_sheet();
    add_dashpots(scene, 1e-3);
    scene.forces.damping = 1e-3;
    scene.wind = WindDescription{};
    scene.wind->gust.model = GustModel::none;
    EXPECT_FALSE(is_conservative(scene));
    const EnergyRun run = fly(scene, {"rk4", 2e-4, 4000, 100, false});
    ASSERT_TRUE(run.failure.empty()) << run.failure;
    const EnergySample &first = run.samples.front(), &last = run.samples.back();
    EXPECT_NEAR(last.time, 0.8, 1e-12);
    EXPECT_GT(std::abs(last.work), 1e-3);
    EXPECT_NEAR(last.account(), first.account(), 1e-4 * std::abs(last.work));
}

TEST(EnergyAccount, OfTheConservativeSceneNeedsNoWork) {
    SceneDescription scene = swinging_sheet();
    add_dashpots(scene, 1e-3);
    scene.forces.damping = 1e-3;
    scene.wind = WindDescription{};
    scene.pins.front().motion = {{0.0, {}}, {1.0, {0.1, 0.0, 0.0}}};
    const SceneDescription conservative = conservative_scene(scene);
    EXPECT_TRUE(is_conservative(conservative));
    EXPECT_FALSE(is_conservative(scene));
    const EnergyRun run = fly(conservative, {"rk4", 5e-4, 2000, 100, false});
    EXPECT_EQ(run.samples.back().work, 0.0);
    EXPECT_NEAR(run.samples.back().total(), run.samples.front().total(), 1e-6);
    EXPECT_GE(run.samples.size(), 300u);  // the first 300 steps and a hundred more
}

TEST(EnergyAccount, OfAFlightThatBlowsUpEndsThere) {
    const EnergyRun run = fly(swinging_sheet(), {"forward-euler", 0.01, 4000, 100, false});
    EXPECT_FALSE(run.failure.empty());
    EXPECT_LT(run.steps, 4000u);
    for (const EnergySample& sample : run.samples) EXPECT_TRUE(std::isfinite(sample.total()));
}

TEST(EnergyExperiment, TellsWhoKeepsIt) {
    TemporaryStudy study(swinging_sheet(), quick_study({"forward-euler", "velocity-verlet",
                                                        "symplectic-euler", "implicit-euler"}));
    const Section section = measure_energy(study.laboratory());
    ASSERT_TRUE(section.skipped.empty()) << section.skipped;
    EXPECT_NE(section.answer.find("symplectic-euler, velocity-verlet keep"), std::string::npos)
        << section.answer;
    EXPECT_NE(section.answer.find("implicit-euler loses"), std::string::npos) << section.answer;
    EXPECT_NE(section.answer.find("forward-euler gains"), std::string::npos) << section.answer;
    EXPECT_EQ(section.findings.size(), 3u);
    const auto& table = std::get<Table>(section.blocks.front());
    EXPECT_EQ(table.rows.size(), 4u);
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
}

TEST(EnergyExperiment, DrawsTheBalanceOfASceneInAir) {
    SceneDescription scene = swinging_sheet();
    scene.wind = WindDescription{};
    TemporaryStudy study(scene, quick_study({"rk3"}));
    const Section section = measure_energy(study.laboratory());
    int balances = 0, by_kind = 0;
    for (const Block& block : section.blocks) {
        const auto* plot = std::get_if<Plot>(&block);
        if (plot == nullptr) continue;
        EXPECT_FALSE(plot->series.empty()) << plot->id;
        balances += plot->id == "balance" ? 1 : 0;
        by_kind += plot->id.starts_with("kinds-") ? 1 : 0;
    }
    EXPECT_EQ(balances, 1);
    EXPECT_EQ(by_kind, 1);
}

TEST(EnergyExperiment, DoesNotApplyWhereNothingMoves) {
    SceneDescription scene = swinging_sheet();
    scene.forces.gravity = {};
    TemporaryStudy still(scene, quick_study());
    EXPECT_NE(measure_energy(still.laboratory()).skipped.find("Nothing moves"), std::string::npos);
    SceneDescription loose = swinging_sheet();
    loose.material.structural = loose.material.shear = loose.material.bend = {};
    TemporaryStudy falling(loose, quick_study());
    EXPECT_FALSE(measure_energy(falling.laboratory()).skipped.empty());
}

}  // namespace
}  // namespace weft::lab
