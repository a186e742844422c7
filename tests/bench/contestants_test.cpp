// What takes part in a timing does the work that it is timed for.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bench/peers/built_in.h"
#include "bench/peers/textbook.h"
#include "bench/suite/contestant.h"
#include "bench/suite/pinned_copies.h"
#include "bench/suite/scenes.h"
#include "support/methods.h"
#include "weft/error.h"
#include "weft/integrators.h"
#include "weft/simulation.h"

namespace weft::bench {
namespace {

const PlainSheet small_sheet{.columns = 12, .rows = 10};

TEST(Contestants, TimingsAreMadeLongEnough) {
    std::vector<int> tried;
    const auto cold_at_first = [&](int pieces) {
        tried.push_back(pieces);
        return tried.size() == 1 ? 0.010 : 0.001 * pieces;
    };
    EXPECT_EQ(pieces_lasting(0.030, cold_at_first), 30);
    EXPECT_EQ(tried, (std::vector{1, 3, 30}));
    EXPECT_EQ(pieces_lasting(0.030, [](int) { return 0.5; }), 1);
    EXPECT_EQ(pieces_lasting(0.030, [](int n) { return n < 1000 ? 0.0 : 1e-5 * n; }), 10000);
}

TEST(Contestants, WeftIsTimedByWholeFramesForLongEnough) {
    const auto weft = make_stepping(sheet_scene(small_sheet, {.steps_per_frame = 50}), 1);
    const Measurement first = weft->measure(0.005), second = weft->measure(0.005);
    EXPECT_GT(first.seconds, 0.001);
    EXPECT_GE(first.steps, 50.0);
    EXPECT_EQ(std::fmod(first.steps, 50.0), 0.0);
    EXPECT_EQ(second.steps, first.steps);
    EXPECT_EQ(first.frames, 0.0);
}

TEST(Contestants, PeersTakeTheSameStepsEveryTime) {
    const auto peer = make_stepping(make_textbook(small_sheet));
    const Measurement first = peer->measure(0.005), second = peer->measure(0.005);
    EXPECT_GT(first.seconds, 0.001);
    EXPECT_GE(first.steps, 1.0);
    EXPECT_EQ(second.steps, first.steps);
}

TEST(Contestants, EveryMethodKeepsTheTimedSheetCalm) {
    const PlainSheet sheet{.columns = 20, .rows = 20};
    for (const IntegratorInfo& info : test::explicit_methods()) {
        Simulation simulation(sheet_scene(sheet, {info.name, Precision::f32, 2000}));
        EXPECT_TRUE(simulation.advance_frame().ok()) << info.name;
        EXPECT_EQ(simulation.time(), 0.1) << info.name;
        EXPECT_LT(std::abs(simulation.largest_strain().strain), 0.5) << info.name;
        EXPECT_GT(simulation.stable_step(info.name), 1.9 * sheet_step) << info.name;
    }
}

TEST(Contestants, TheMeshIsTheGridInAnotherOrder) {
    const Stepping stepping{"symplectic-euler", Precision::f64, 200};
    Simulation grid(sheet_scene(small_sheet, stepping)), mesh(mesh_scene(small_sheet, stepping));
    EXPECT_EQ(mesh.spring_counts(), grid.spring_counts());
    EXPECT_EQ(mesh.pinned_count(), std::size_t{2});
    EXPECT_EQ(mesh.mesh_findings(),
              std::vector<std::string>{"no texture co-ordinates: they follow x and y"});
    EXPECT_EQ(mesh.scene().cloth.mesh->positions.size(), small_sheet.particle_count());
    EXPECT_FALSE(mesh.scene().cloth.mesh->positions[1] == small_sheet.rest_position(1, 0));
    ASSERT_TRUE(grid.advance_frame().ok() && mesh.advance_frame().ok());
    EXPECT_NEAR(mesh.energy().total(), grid.energy().total(), 1e-12);
    EXPECT_NEAR(mesh.energy().springs(), grid.energy().springs(), 1e-12);
}

TEST(Contestants, TheFlagDiffersByTheWindAlone) {
    SceneDescription with = flag_scene(30, 20, true, {}), without = flag_scene(30, 20, false, {});
    EXPECT_TRUE(with.wind.has_value());
    EXPECT_FALSE(without.wind.has_value());
    EXPECT_EQ(with.integrator.time_step, without.integrator.time_step);
    EXPECT_TRUE(Simulation(with).advance_frame().ok());
    EXPECT_TRUE(Simulation(without).advance_frame().ok());
}

TEST(Contestants, TwoSecondsEndWithTheSheetHangingStill) {
    const PlainSheet sheet{.columns = 12, .rows = 12, .drag = 1e-3};
    const auto weft = make_two_seconds(sheet, sheet_at_60_hertz(sheet, "velocity-verlet"));
    const Measurement first = weft->measure(0.0), second = weft->measure(0.0);
    EXPECT_EQ(first.frames, 120.0);
    EXPECT_GT(first.steps, 120.0);
    ASSERT_TRUE(first.sag.has_value());
    EXPECT_EQ(first.sag, second.sag);  // each time from the start
    EXPECT_GT(*first.sag, 1e-4);
    EXPECT_LT(*first.sag, 0.1);
}

TEST(Contestants, TheHangingSheetSagsAlikeByEveryMethod) {
    const PlainSheet sheet = hanging_sheet(12);
    EXPECT_DOUBLE_EQ(sheet.mass * 144, 0.2);
    EXPECT_DOUBLE_EQ(sheet.cell * 11, 1.0);
    const auto sag_by = [&](std::string_view method, std::optional<double> step) {
        return make_two_seconds(sheet, sheet_at_60_hertz(sheet, method, step))->measure(0.0).sag;
    };
    const std::optional<double> sag = sag_by("auto", {});
    ASSERT_TRUE(sag.has_value());
    EXPECT_GT(*sag, 1e-3);
    EXPECT_NEAR(*sag_by("implicit-euler", 1.0 / 60), *sag, 1e-5);
    EXPECT_NEAR(*sag_by("tr-bdf2", 1.0 / 60), *sag, 1e-5);
}

TEST(Contestants, DivergenceIsAnError) {
    SceneDescription scene = sheet_scene(small_sheet, {.steps_per_frame = 1000});
    scene.integrator.time_step = 0.01;
    scene.output.frames_per_second = 0.1;
    const auto weft = make_stepping(scene, 1);
    try {
        weft->measure(0.001);
        FAIL() << "it cannot be stable";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::diverged);
        EXPECT_NE(std::string(error.what()).find("diverged in step"), std::string::npos);
    }
}

TEST(Contestants, PinnedCopiesAllStep) {
    PinnedCopies copies;
    copies.start();
    ASSERT_GE(copies.count(), 1);
    const auto contestant = copies.make({.columns = 12, .rows = 10, .steps_per_frame = 100});
    const Measurement found = contestant->measure(0.005);
    EXPECT_GT(found.seconds, 0.0);
    EXPECT_EQ(std::fmod(found.steps, 100.0 * copies.count()), 0.0);
    EXPECT_GT(found.steps, 0.0);
}

TEST(Contestants, ACopyThatCannotGoOnIsAnError) {
    PinnedCopies copies;
    copies.start();
    EXPECT_THROW(copies.make({.columns = 1, .rows = 10, .steps_per_frame = 100}), Error);
    EXPECT_NO_THROW(copies.make({.columns = 12, .rows = 10, .steps_per_frame = 100}));
}

}  // namespace
}  // namespace weft::bench
