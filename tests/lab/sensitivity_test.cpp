// How fast two flights part: made-up growth, a cloth that does not part, one that does.
#include "lab/sensitivity/sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lab/experiment.h"
#include "support/cloth_scenes.h"
#include "support/temporary_study.h"

namespace weft::lab {
namespace {

using test::bare_sheet;
using test::no_watch;
using test::quick_study;
using test::TemporaryStudy;

// Held flat at two corners, it falls, folds and flaps.
SceneDescription falling_sheet() {
    SceneDescription scene = bare_sheet(8, 8);
    scene.cloth.grid.plane = Plane::xz;
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    scene.output.duration = 3.0;
    return scene;
}

TEST(PartingRate, IsTheExponentOfTheGrowth) {
    Parting parting;
    for (int n = 0; n <= 100; ++n) {
        const double t = 0.1 * n;
        parting.points.push_back({t, t < 2.0 ? 1e-12 : 1e-12 * std::exp(3.0 * (t - 2.0))});
    }
    const std::optional<PartingRate> rate = parting_rate(parting, 1e-11, 1e-4);
    ASSERT_TRUE(rate.has_value());
    EXPECT_NEAR(rate->rate, 3.0, 1e-9);
    EXPECT_NEAR(rate->from, 2.8, 1e-9);  // ln 10 / 3 after 2 s
    EXPECT_NEAR(rate->to, 8.2, 1e-9);
    EXPECT_NEAR(*parting.reaches(1e-6), 6.7, 1e-9);
    EXPECT_FALSE(parting.reaches(1.0).has_value());
    EXPECT_FALSE(parting_rate(parting, 1.0, 2.0).has_value());
}

// Free fall: what begins apart stays so.
TEST(Parting, OfAClothThatFallsFreelyDoesNotGrow) {
    SceneDescription scene = bare_sheet(5, 5);
    scene.forces.gravity = {0.0, -9.81, 0.0};
    const Parting parting = part(scene, {"velocity-verlet", 1e-3, 2000, 1e-9, true, 0.0}, no_watch);
    EXPECT_TRUE(parting.failure.empty());
    EXPECT_NEAR(parting.points.front()[1], 1e-9 / 5.0, 1e-13);  // one particle of 25
    EXPECT_LT(parting.points.back()[1], 2e-9);
    EXPECT_FALSE(parting_rate(parting, 2e-9, 1e-2).has_value());
}

// Small nudges part as large ones do, a thousand times closer.
TEST(Parting, GrowsInProportionToTheNudge) {
    const SceneDescription scene = falling_sheet();
    const auto fly = [&](double nudge) {
        return part(scene, {"velocity-verlet", 1e-3, 800, nudge, true, 0.0}, no_watch);
    };
    const Parting small = fly(1e-10), large = fly(1e-7);
    ASSERT_EQ(small.points.size(), large.points.size());
    for (std::size_t n = 0; n < small.points.size(); ++n) {
        EXPECT_NEAR(large.points[n][1] / small.points[n][1], 1000.0, 30.0);
    }
}

TEST(Parting, EndsWhereItIsFarEnoughOrDiverges) {
    const SceneDescription scene = falling_sheet();
    const Parting all = part(scene, {"velocity-verlet", 1e-3, 100, 1e-3, false, 0.5e-3}, no_watch);
    EXPECT_EQ(all.points.size(), 1u);
    EXPECT_NEAR(all.points.front()[1], 1e-3, 0.2e-3);
    const Parting wild = part(scene, {"velocity-verlet", 1.0, 4000, 1e-9, true, 0.0}, no_watch);
    EXPECT_FALSE(wild.failure.empty());
    for (const auto& point : wild.points) EXPECT_TRUE(std::isfinite(point[1]));
    EXPECT_THROW(part(scene, {"rk4", 1e-3, 10, 1e-9, true, 0.0}, [] { throw Interrupted{}; }),
                 Interrupted);
}

TEST(MeaningfulTime, IsLongerForASmallerError) {
    const SceneDescription scene = falling_sheet();
    const double coarse = meaningful_time(scene, 1e-4, 0.02, 10.0, no_watch),
                 fine = meaningful_time(scene, 1e-9, 0.02, 10.0, no_watch);
    EXPECT_GT(coarse, 0.0);
    EXPECT_LT(coarse, fine);
    EXPECT_LE(fine, 10.0);
    // A cloth that nothing moves does not part.
    SceneDescription still = bare_sheet(4, 4);
    EXPECT_EQ(meaningful_time(still, 1e-9, 0.02, 1.0, no_watch), 1.0);
}

TEST(CellSize, IsTheMeanOfStructuralSprings) {
    EXPECT_NEAR(cell_size(Specimen(bare_sheet(5, 5, 1.0, 0.5)).cloth()), 0.1875, 1e-12);
}

TEST(SensitivityExperiment, TellsWhenTwoFlightsPart) {
    TemporaryStudy study(falling_sheet(), quick_study());
    const Section section = measure_sensitivity(study.laboratory());
    ASSERT_TRUE(section.skipped.empty()) << section.skipped;
    EXPECT_FALSE(section.answer.empty());
    EXPECT_EQ(section.blocks.size(), 3u);
    EXPECT_EQ(std::get<Table>(section.blocks[1]).rows.size(), 4u);
    EXPECT_EQ(std::get<Plot>(section.blocks[0]).series.size(), 5u);
}

TEST(SensitivityExperiment, DoesNotApplyWithoutSprings) {
    SceneDescription scene = falling_sheet();
    scene.material.structural = scene.material.shear = scene.material.bend = {};
    TemporaryStudy study(scene, quick_study());
    EXPECT_FALSE(measure_sensitivity(study.laboratory()).skipped.empty());
}

}  // namespace
}  // namespace weft::lab
