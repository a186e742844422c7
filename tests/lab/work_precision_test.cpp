// What costs least: fronts of made-up points, the three scenes, series of flights, the experiment.
#include <gtest/gtest.h>

#include <cmath>

#include "lab/experiment.h"
#include "lab/work_precision/pareto.h"
#include "lab/work_precision/work_flights.h"
#include "lab/work_precision/work_scenes.h"
#include "support/cloth_scenes.h"
#include "support/temporary_study.h"
#include "weft/integrators.h"

namespace weft::lab {
namespace {

using test::bare_sheet;
using test::no_watch;
using test::quick_study;
using test::TemporaryStudy;

SceneDescription swinging_sheet() {
    SceneDescription scene = bare_sheet(5, 4);
    scene.forces.gravity = {0.0, -9.81, 2.0};
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    scene.output.duration = 1.0;
    return scene;
}

TEST(ParetoFront, HasWhatIsNotBeatenInBoth) {
    const std::vector<CostAndError> points{{3.0, 1.0}, {1.0, 5.0}, {2.0, 5.0},
                                           {2.0, 2.0}, {4.0, 1.0}, {9.0, 0.5}};
    EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{1, 3, 0, 5}));
}

TEST(ParetoFront, TakesTheFirstOfEqualsAndNothingThatFailed) {
    EXPECT_EQ(pareto_front(std::vector<CostAndError>{{1.0, 1.0}, {1.0, 1.0}}),
              std::vector<std::size_t>{0});
    EXPECT_EQ(pareto_front(std::vector<CostAndError>{{1.0, INFINITY}, {NAN, 1.0}, {2.0, 3.0}}),
              std::vector<std::size_t>{2});
    EXPECT_TRUE(pareto_front({}).empty());
}

TEST(WorkScenes, AreSofterStifferAndWindier) {
    SceneDescription scene = swinging_sheet();
    scene.material.shear.damping = 0.5;
    const std::vector<WorkScene> scenes = work_scenes(scene);
    ASSERT_EQ(scenes.size(), 3u);
    const MaterialDescription& soft = scenes[0].scene.material;
    EXPECT_DOUBLE_EQ(soft.structural.stiffness, 10.0);
    EXPECT_DOUBLE_EQ(soft.shear.damping, 0.05);
    EXPECT_FALSE(scenes[0].scene.wind.has_value());
    EXPECT_DOUBLE_EQ(scenes[1].scene.material.structural.stiffness, 10'000.0);
    Specimen stiff(scenes[1].scene);
    const Mode& fastest = stiff.modes().modes.front();
    EXPECT_NEAR(fastest.damping_rate / (2.0 * fastest.omega), 0.1, 0.001);
    ASSERT_TRUE(scenes[2].scene.wind.has_value());
    EXPECT_EQ(scenes[2].scene.material.structural.stiffness, 100.0);
    EXPECT_NE(scenes[2].text.find("in the wind of the shipped flag, (4, 0, 1.4) m/s"),
              std::string::npos);
}

TEST(WorkScenes, KeepTheirOwnWindWithoutItsGusts) {
    SceneDescription scene = swinging_sheet();
    scene.wind = WindDescription{};
    scene.wind->velocity = {0.0, 0.0, 7.0};
    for (const WorkScene& made : work_scenes(scene)) {
        EXPECT_EQ(made.scene.wind->velocity.z, 7.0);
        EXPECT_EQ(made.scene.wind->gust.model, GustModel::none);
    }
    EXPECT_NE(work_scenes(scene)[2].text.find("as it is, in its own wind of (0, 0, 7) m/s"),
              std::string::npos);
}

TEST(WorkStretch, IsShortenedWhereErrorsWouldGrow) {
    SceneDescription scene = swinging_sheet();
    Specimen specimen(scene);
    const WorkStretch calm = find_work_stretch(specimen, true, no_watch);
    ASSERT_TRUE(calm.failure.empty());
    EXPECT_NEAR(calm.wanted, 0.5, 1e-12);
    EXPECT_GT(calm.motion, 0.05);
    EXPECT_LT(calm.reference_error, 1e-6 * calm.motion);
    EXPECT_EQ(rms_distance(specimen.cloth(), calm.start, specimen.start()), 0.0);
    scene.forces.gravity = {0.0, 30.0, 1e-3};  // upward against the pins: it buckles at once
    scene.material.structural.stiffness = 1e4;
    scene.output.duration = 4.0;
    Specimen buckling(scene);
    const WorkStretch wild = find_work_stretch(buckling, false, no_watch);
    EXPECT_TRUE(wild.shortened()) << wild.length() << " of " << wild.wanted;
}

class WorkFlights : public ::testing::Test {
protected:
    WorkFlights()
        : specimen_(swinging_sheet()), stretch_(find_work_stretch(specimen_, true, no_watch)) {}

    WorkSeries series(std::string_view method) {
        return measure_work(specimen_, {method, true}, stretch_, no_watch);
    }

    Specimen specimen_;
    WorkStretch stretch_;
};

TEST_F(WorkFlights, GoOnUntilTheyAreExact) {
    for (const char* method : {"velocity-verlet", "rk4", "dopri5"}) {
        const WorkSeries found = series(method);
        ASSERT_FALSE(found.points.empty()) << method;
        EXPECT_LE(found.points.back().error, 5e-5 * stretch_.motion) << method;
        EXPECT_FALSE(found.bounded) << method;
        for (const WorkPoint& point : found.points) {
            EXPECT_TRUE(point.ok());
            EXPECT_GT(point.ms, 0.0);
            EXPECT_GT(point.evaluations, 0u);
        }
    }
    EXPECT_EQ(series("rk4").points[0].evaluations, 4 * series("rk4").points[0].steps);
    EXPECT_GT(series("dopri5").points[0].tolerance, 0.0);
    const WorkSeries implicit = series("implicit-midpoint");
    EXPECT_GT(implicit.points[0].newton_iterations, 0u);
    EXPECT_LT(implicit.points.back().error, 1e-3 * stretch_.motion);
}

TEST_F(WorkFlights, AreBoundedByWorkNotByTime) {
    const WorkSeries one = series("vbd"), other = series("vbd");
    EXPECT_TRUE(one.bounded);
    ASSERT_EQ(one.points.size(), other.points.size());
    for (std::size_t n = 0; n < one.points.size(); ++n) {
        EXPECT_EQ(one.points[n].error, other.points[n].error);
        EXPECT_EQ(one.points[n].newton_iterations, other.points[n].newton_iterations);
    }
}

TEST_F(WorkFlights, ComeBackFromJson) {
    const WorkSeries found = series("bosh3");
    const WorkSeries read =
        work_series_from_json(nlohmann::json::parse(work_series_to_json(found).dump()));
    ASSERT_EQ(read.points.size(), found.points.size());
    EXPECT_EQ(read.points[0].error, found.points[0].error);
    EXPECT_EQ(read.points[0].tolerance, found.points[0].tolerance);
    EXPECT_EQ(read.points[0].ms, found.points[0].ms);
    WorkSeries failed;
    failed.points.push_back({0.1, 0.0, 3, 3, 0, 0, INFINITY, 1.0, "it blew up"});
    const WorkSeries again =
        work_series_from_json(nlohmann::json::parse(work_series_to_json(failed).dump()));
    EXPECT_TRUE(std::isinf(again.points[0].error));
    EXPECT_EQ(again.points[0].failure, "it blew up");
}

std::vector<const Table*> tables_of(const Section& section) {
    std::vector<const Table*> tables;
    for (const Block& block : section.blocks) {
        if (const Table* table = std::get_if<Table>(&block)) tables.push_back(table);
    }
    return tables;
}

TEST(WorkPrecisionExperiment, RanksMethodsOnThreeScenes) {
    const std::vector<std::string> methods{"forward-euler", "velocity-verlet", "rk4", "tr-bdf2"};
    TemporaryStudy study(swinging_sheet(), quick_study(methods));
    const Section section = measure_work_precision(study.laboratory());
    const std::vector<const Table*> tables = tables_of(section);
    ASSERT_EQ(tables.size(), 6u);
    for (const std::size_t n : {0u, 2u, 4u}) {
        EXPECT_EQ(tables[n]->rows.size(), methods.size());
        EXPECT_EQ(tables[n]->columns[1].name, "to 10 % [ms, varies]");
        for (const auto& row : tables[n]->rows) ASSERT_EQ(row.size(), tables[n]->columns.size());
    }
    for (const auto& row : tables[1]->rows) ASSERT_EQ(row.size(), tables[1]->columns.size());
    EXPECT_EQ(section.answer.find("Cheapest to 1 % of the motion: "), 0u);
    EXPECT_EQ(section.answer.find("no method"), std::string::npos);
    EXPECT_EQ(section.findings.size(), 6u);
    const Section again = measure_work_precision(study.laboratory());  // from what was kept
    EXPECT_EQ(again.answer, section.answer);
    for (std::size_t n = 0; n < tables.size(); ++n) {
        EXPECT_EQ(tables_of(again)[n]->rows, tables[n]->rows);
    }
}

TEST(WorkPrecisionExperiment, MarksTheFront) {
    TemporaryStudy study(swinging_sheet(), quick_study({"velocity-verlet", "rk4"}));
    const Section section = measure_work_precision(study.laboratory());
    std::size_t plots = 0;
    for (const Block& block : section.blocks) {
        const Plot* plot = std::get_if<Plot>(&block);
        if (plot == nullptr) continue;
        ++plots;
        const Series& front = plot->series.back();
        EXPECT_EQ(front.name, "not beaten");
        EXPECT_EQ(front.look, "neutral");
        for (std::size_t n = 1; n < front.points.size(); ++n) {
            EXPECT_GT(front.points[n][0], front.points[n - 1][0]);
            EXPECT_LT(front.points[n][1], front.points[n - 1][1]);
        }
    }
    EXPECT_EQ(plots, 3u);
}

TEST(WorkPrecisionExperiment, IsSkippedWhereNothingMoves) {
    SceneDescription scene = bare_sheet(3, 3);
    scene.pins = {{EdgeSelection::left_edge, {}}};
    scene.wind = WindDescription{};
    scene.wind->velocity = {};
    TemporaryStudy study(scene, quick_study({"rk4"}));
    const Section section = measure_work_precision(study.laboratory());
    EXPECT_NE(section.skipped.find("Nothing moves in it."), std::string::npos);
}

}  // namespace
}  // namespace weft::lab
