// The error of one step, and the comparison's table 1 beside it.
#include <gtest/gtest.h>

#include <cmath>

#include "lab/experiment.h"
#include "lab/order/printed_errors.h"
#include "lab/scene_stretch.h"
#include "lab/seed_sheet.h"
#include "support/cloth_scenes.h"
#include "support/sections.h"
#include "support/temporary_study.h"
#include "weft/integrators.h"

namespace weft::lab {
namespace {

using test::bare_sheet;
using test::no_watch;
using test::quick_study;
using test::table_of;
using test::TemporaryStudy;

SceneDescription swinging_sheet() {
    SceneDescription scene = bare_sheet(5, 4);
    scene.forces.gravity = {0.0, -9.81, 2.0};
    scene.pins = {{EdgeSelection::top_left, {}}};
    return scene;
}

TEST(LocalErrorExperiment, ShowsOneOrderMoreForEveryMethod) {
    TemporaryStudy study(swinging_sheet(), quick_study());
    const Section section = measure_local_error(study.laboratory());
    const Table& fits = table_of(section, "fits");
    ASSERT_EQ(fits.rows.size(), integrator_catalogue().size());
    for (const std::vector<Cell>& row : fits.rows) {
        EXPECT_NEAR(std::get<double>(row[2]), std::get<double>(row[1]), 0.1)
            << std::get<std::string>(row[0]);
    }
    EXPECT_NE(section.answer.find("on the scene 22 of 22 methods show the local order p + 1"),
              std::string::npos);
}

TEST(LocalErrorExperiment, SaysWhyASceneCannotBeMeasuredOn) {
    SceneDescription scene = swinging_sheet();
    scene.forces.gravity = {0.0, -1e9, 0.0};  // tears any cloth
    TemporaryStudy study(scene, quick_study({"rk4"}));
    const Section section = measure_local_error(study.laboratory());
    const Paragraph* last = std::get_if<Paragraph>(&section.blocks.back());
    ASSERT_NE(last, nullptr);
    EXPECT_EQ(last->text.find("The scene itself could not be measured on: rk4 diverged"), 0u);
    EXPECT_EQ(table_of(section, "printed-errors").rows.size(), 3u);
    EXPECT_EQ(section.answer.back(), '.');
}

class PrintedErrorsTest : public ::testing::Test {
protected:
    PrintedErrorsTest()
        : sheet_(seed_scene({})), reference_(printed_errors_reference().measure(no_watch)) {
        std::vector<nlohmann::json> results;
        for (const Trial& trial : printed_errors_trials(reference_)) {
            results.push_back(trial.measure(no_watch));
        }
        found_ = printed_errors(results);
    }

    [[nodiscard]] double number(std::size_t row, std::size_t column) const {
        return std::get<double>(found_.table.rows[row][column]);
    }

    Specimen sheet_;
    nlohmann::json reference_;
    PrintedErrors found_;
};

TEST_F(PrintedErrorsTest, ArePowersOfTheStep) {
    ASSERT_EQ(found_.table.rows.size(), 3u);
    for (std::size_t row = 0; row < 3; ++row) EXPECT_NEAR(number(row, 2), number(row, 4), 1e-15);
}

// Forward Euler's step is x + dt v, Verlet's first x + dt v + dt^2 a / 2.
TEST_F(PrintedErrorsTest, StandBesideErrorsOfOneStep) {
    const ParticleState<double> moving = state_from_json(sheet_.cloth(), reference_.at("moving")),
                                after = state_from_json(sheet_.cloth(), reference_.at("after"));
    EXPECT_NEAR(moving.time, 1.0, 1e-12);
    EXPECT_NEAR(after.time, 1.016, 1e-12);
    Vec3Array<double> a(moving.x.size());
    sheet_.system().acceleration(1.0, moving.x.view(), moving.v.view(), a.view());
    ParticleState<double> euler = moving, verlet = moving;
    for (std::size_t s = 0; s < moving.x.size(); ++s) {
        euler.x.set(s, moving.x[s] + 0.016 * moving.v[s]);
        verlet.x.set(s, euler.x[s] + (0.5 * 0.016 * 0.016) * a[s]);
    }
    EXPECT_NEAR(number(0, 5), rms_distance(sheet_.cloth(), euler, after), 1e-12);
    EXPECT_NEAR(number(1, 5), rms_distance(sheet_.cloth(), verlet, after), 1e-12);
    EXPECT_NEAR(number(0, 5), 1.77e-3, 0.01e-3);  // [m]
    EXPECT_LT(number(2, 5), number(1, 5));        // rk3 less than verlet, verlet less than Euler
    EXPECT_LT(number(1, 5), number(0, 5));
}

TEST_F(PrintedErrorsTest, StandBesideErrorsAfterASecond) {
    EXPECT_EQ(std::get<std::string>(found_.table.rows[0][10]).find("blew up"), 0u);
    EXPECT_LT(number(1, 10), 1e-3);
    EXPECT_LT(number(2, 10), 1e-3);
    EXPECT_NE(found_.answer.find("while forward-euler blew up"), std::string::npos);
}

TEST(SceneStretch, IsInMotionAndSmooth) {
    SceneDescription scene = swinging_sheet();
    scene.wind = WindDescription{};
    scene.wind->velocity = {0.0, 0.0, 6.0};
    scene.wind->gust.period = 0.2;
    Specimen specimen(scene);
    const SceneStretch stretch = find_scene_stretch(specimen, true, no_watch);
    ASSERT_TRUE(stretch.failure.empty());
    EXPECT_GE(stretch.start.time, 0.25);
    EXPECT_NEAR(stretch.length(), 8.0 * stretch.limit, 1e-12);
    EXPECT_EQ(std::floor(stretch.start.time / 0.2), std::floor(stretch.end.time / 0.2));
    EXPECT_GT(stretch.motion, 1e-3);
    EXPECT_LT(stretch.reference_error, 1e-11);
    EXPECT_EQ(stretch.triangles, 24u);
    const SceneStretch read = stretch_from_json(
        specimen.cloth(), nlohmann::json::parse(stretch_to_json(specimen.cloth(), stretch).dump()));
    EXPECT_EQ(rms_distance(specimen.cloth(), read.end, stretch.end), 0.0);
    EXPECT_EQ(read.start.time, stretch.start.time);
}

// Held all around in wind from behind it stays as it is met; a loose one flutters.
TEST(SceneStretch, CountsTrianglesThatTheAirMeetsEdgeOn) {
    SceneDescription scene = swinging_sheet();
    scene.wind = WindDescription{};
    scene.wind->velocity = {0.0, 0.0, 9.0};
    scene.wind->gust.model = GustModel::none;
    SceneDescription held = scene;
    held.pins = {{EdgeSelection::top_edge, {}}, {EdgeSelection::bottom_edge, {}}};
    Specimen sail(held);
    EXPECT_EQ(find_scene_stretch(sail, true, no_watch).edge_on, 0u);
    scene.wind->velocity = {8.0, 0.0, 0.2};
    Specimen flag(scene);
    EXPECT_GT(find_scene_stretch(flag, false, no_watch).edge_on, 0u);
}

}  // namespace
}  // namespace weft::lab
