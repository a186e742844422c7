// Rest and blow-up: what the two readings of "stable time" measure, and the causes that make the
// printed order.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "io/scene_json.h"
#include "lab/order/test_problems.h"
#include "lab/settle/settle_parts.h"
#include "support/cloth_scenes.h"
#include "support/temporary_study.h"
#include "weft/integrators.h"

namespace weft::lab {
namespace {

using test::no_watch;

namespace fs = std::filesystem;
RestRun wrecked_at(std::optional<double> time) {
    RestRun run;
    run.blow_up = time;
    return run;
}

/// A study in a directory that goes with it.
class SettleTest : public ::testing::Test {
protected:
    SettleTest()
        : directory_(
              fs::temp_directory_path() /
              ("weft-settle-" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        fs::remove_all(directory_);
    }
    ~SettleTest() override { fs::remove_all(directory_); }

    [[nodiscard]] Laboratory laboratory(const SceneDescription& scene = {}) const {
        LabOptions options;
        options.quick = true;
        Laboratory made(scene, directory_, options);
        made.begin_experiment("settle", 1.0, 1);
        return made;
    }

    fs::path directory_;
};

TEST(RestRun, RestIsWhenTheKineticEnergyStaysSmall) {
    // Masses of 1 kg on springs, w = 5, drag 1 /s: the energy falls as e^-t, to a thousandth of the
    // first swing's after some seven seconds; the last swing above it is within half a period.
    SceneDescription scene = hanging_masses();
    scene.forces.damping = 1.0;
    Specimen specimen(scene);
    RestPlan plan;
    plan.method = "rk4";
    plan.time_step = 0.01;
    plan.duration = 20.0;
    const RestRun run = run_to_rest(specimen, plan, no_watch);
    ASSERT_TRUE(run.rest);
    EXPECT_NEAR(*run.rest, std::log(1000.0), 0.7);
    EXPECT_FALSE(run.wrecked());
    EXPECT_EQ(run.samples.size(), 41u);  // every 0.5 s, with both ends
    EXPECT_NEAR(run.at(7.1).time, 7.0, 1e-9);
    EXPECT_TRUE(std::isnan(run.at(30.0).kinetic));
}

TEST(RestRun, WhatIsNotDampedDoesNotRest) {
    Specimen specimen(hanging_masses());
    RestPlan plan;
    plan.method = "rk4";
    plan.time_step = 0.01;
    plan.duration = 20.0;
    const RestRun run = run_to_rest(specimen, plan, no_watch);
    EXPECT_FALSE(run.rest);
    EXPECT_FALSE(run.wrecked());
}

TEST(RestRun, EnergyOutOfNothingComesBeforeTheBlowUp) {
    // Forward Euler multiplies the energy of the oscillation by 1 + (w dt)^2 = 1.0025 a step: from
    // one swing's energy to twice that takes ln 2 / ln 1.0025 = 278 steps.
    Specimen specimen(hanging_masses());
    const double swing = 2.0 * 9.81 * 9.81 / 25.0 / 2.0;  // m g^2 / (2 w^2) of two masses [J]
    RestPlan plan;
    plan.method = "forward-euler";
    plan.time_step = 0.01;
    plan.duration = 100.0;
    plan.released = swing;
    const RestRun run = run_to_rest(specimen, plan, no_watch);
    ASSERT_TRUE(run.gain && run.blow_up);
    EXPECT_NEAR(*run.gain, 2.78, 0.05);
    EXPECT_GT(*run.blow_up, *run.gain);
    EXPECT_EQ(run.wrecked(), run.gain);
    EXPECT_FALSE(run.rest);
}

TEST(RestRun, IsKeptWithoutLoss) {
    RestRun run;
    run.rest = 1.0 / 3.0;
    run.failure = "why";
    run.samples = {{0.0, 1.0, 2.0, 3.0, 4.0}, {0.1, 1e-300, -2.5, 1.0 / 7.0, 5.0}};
    const RestRun back = rest_run_from_json(nlohmann::json::parse(to_json(run).dump()));
    EXPECT_EQ(back.rest, run.rest);
    EXPECT_FALSE(back.gain || back.blow_up);
    EXPECT_EQ(back.failure, "why");
    EXPECT_EQ(back.samples[1].wrinkles, 1.0 / 7.0);
    EXPECT_EQ(back.wrecked(), 0.1);  // a failure counts from the last sample
}

TEST(SeedSheet, IsTheShippedScene) {
    nlohmann::json shipped = scene_to_json(load_scene("sheet")),
                   made = scene_to_json(seed_scene({}));
    for (nlohmann::json* scene : {&shipped, &made}) scene->at("material").erase("fabric");
    for (const char* part : {"cloth", "material", "pins", "forces"}) {
        EXPECT_EQ(made.at(part), shipped.at(part)) << part;
    }
    EXPECT_FALSE(made.contains("wind"));
    EXPECT_DOUBLE_EQ(fall_energy({0.5, 0.0, 0.0}), 1600 * 0.5 * 9.81 * 10.0);
    EXPECT_EQ(describe({0.03, 0.5, 0.002}), "0.03 kg, drag 0.5 /s, dashpots c = 2 ms k");
}

TEST(PrintedOrder, IsVerletThenEulerThenRungeKutta) {
    EXPECT_TRUE(in_printed_order(wrecked_at(3.0), wrecked_at(8.0), wrecked_at(15.0)));
    EXPECT_TRUE(in_printed_order(wrecked_at(3.0), wrecked_at(8.0), wrecked_at({})));
    EXPECT_FALSE(in_printed_order(wrecked_at(8.0), wrecked_at(3.0), wrecked_at({})));
    EXPECT_FALSE(in_printed_order(wrecked_at({}), wrecked_at(8.0), wrecked_at({})));
    EXPECT_FALSE(in_printed_order(wrecked_at(3.0), wrecked_at({}), wrecked_at({})));
    EXPECT_FALSE(in_printed_order(wrecked_at(3.0), wrecked_at(8.0), wrecked_at(5.0)));
}

// What the experiment answers, at its own settings: strong dashpots turn the order round.
TEST_F(SettleTest, DashpotsPutVerletFirstToFail) {
    Laboratory lab = laboratory();
    RestBatch batch;
    const SeedSheet bare{1.0, 0.0, 0.0}, dashpots{1.0, 0.0, seed_time_step};
    std::array<std::size_t, 6> runs{};
    std::size_t n = 0;
    for (const SeedSheet& sheet : {bare, dashpots}) {
        for (const char* method : {"verlet", "forward-euler", "rk3"}) {
            runs[n++] = add_seed_run(batch, sheet, method, seed_time_step, 2.0);
        }
    }
    batch.run(lab);
    EXPECT_FALSE(in_printed_order(batch[runs[0]], batch[runs[1]], batch[runs[2]]));
    EXPECT_TRUE(in_printed_order(batch[runs[3]], batch[runs[4]], batch[runs[5]]));
    EXPECT_LT(*batch[runs[1]].wrecked(), 0.6);
    EXPECT_FALSE(batch[runs[0]].wrecked());
    EXPECT_LT(*batch[runs[3]].wrecked(), 0.4);
}

TEST(DashpotTheory, VerletsLimitFallsBelowForwardEulersBeyondZeta045) {
    // 2 zeta = 2 (sqrt(1 + 4 zeta^2) - 2 zeta) at zeta = 1 / sqrt(5) = 0.4472.
    EXPECT_GT(stability_limit("verlet", 0.44), stability_limit("forward-euler", 0.44));
    EXPECT_LT(stability_limit("verlet", 0.455), stability_limit("forward-euler", 0.455));
}

TEST_F(SettleTest, ARunAskedForTwiceIsMadeOnce) {
    RestBatch batch;
    const std::size_t first = add_seed_run(batch, {}, "verlet", 0.01, 0.1);
    EXPECT_EQ(add_seed_run(batch, {}, "verlet", 0.01, 0.1), first);
    EXPECT_NE(add_seed_run(batch, {}, "verlet", 0.02, 0.1), first);
    EXPECT_NE(add_seed_run(batch, {2.0, 0.0, 0.0}, "verlet", 0.01, 0.1), first);
    EXPECT_EQ(batch.size(), 3u);
    // A drag that the update has in itself is not in the scene as well, but it is another run.
    const std::string_view scaled = "verlet (1 - d)(x - x_prev)";
    EXPECT_NE(add_seed_run(batch, {1.0, 0.5, 0.0}, scaled, 0.01, 0.1),
              add_seed_run(batch, {1.0, 0.0, 0.0}, scaled, 0.01, 0.1));
}

TEST_F(SettleTest, AsksForFewerRunsWhenQuick) {
    std::array<std::size_t, 2> runs{};
    for (const bool quick : {false, true}) {
        RestBatch batch;
        const SeedTable table(batch, {"velocity-verlet", "rk4", "dopri5"}, quick);
        EXPECT_EQ(batch.size(), quick ? 20u : 40u);  // methods x dampings x steps x masses
        const SettleSweeps sweeps(batch, quick);
        const SettleCauses causes(batch, quick);
        runs[quick ? 1 : 0] = batch.size();
    }
    EXPECT_GT(runs[0], 150u);
    EXPECT_LT(runs[1], runs[0]);
}

TEST_F(SettleTest, TellsOfTheStudysOwnScene) {
    SceneDescription scene = test::bare_sheet(3, 3);
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.pins = {{EdgeSelection::top_edge, {}}};
    Laboratory lab = laboratory(scene);
    RestBatch batch;
    const SettleScene part(batch, scene, {"velocity-verlet", "rk4"}, true);
    ASSERT_EQ(batch.size(), 10u);
    batch.run(lab);
    Section section;
    part.tell(batch, section);
    const auto& table = std::get<Table>(section.blocks.at(1));
    ASSERT_EQ(table.rows.size(), 10u);
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    EXPECT_EQ(std::get<std::string>(table.rows[0][0]), "forward-euler");
    EXPECT_EQ(std::get<std::string>(table.rows[0].back()), "beyond its limit");
    EXPECT_TRUE(std::holds_alternative<double>(table.rows[0][4]));  // blown up
    EXPECT_EQ(std::get<std::string>(table.rows[1][4]), "none");     // verlet
    EXPECT_NE(part.sentence(batch).find("3 of 10 runs blow up"), std::string::npos)
        << part.sentence(batch);
}

TEST_F(SettleTest, ThePapersSheetIsNotRunTwice) {
    RestBatch batch;
    SceneDescription scene = load_scene("sheet");
    scene.name = "another name";
    scene.integrator.method = "rk4";
    const SettleScene part(batch, scene, {"rk4"}, true);
    EXPECT_EQ(batch.size(), 0u);
    EXPECT_EQ(part.sentence(batch), "");
}

}  // namespace
}  // namespace weft::lab
