// Fits of orders on made-up errors, and the experiment on every method.
#include <gtest/gtest.h>

#include <cmath>

#include "lab/experiment.h"
#include "lab/order/convergence.h"
#include "lab/order/order_fit.h"
#include "lab/order/order_plot.h"
#include "lab/order/order_problems.h"
#include "lab/order/test_problems.h"
#include "support/cloth_scenes.h"
#include "support/sanitized.h"
#include "support/sections.h"
#include "support/temporary_study.h"

namespace weft::lab {
namespace {

using test::bare_sheet;
using test::no_watch;
using test::quick_study;
using test::table_of;
using test::TemporaryStudy;

// error = factor step^order at 2^-first ... 2^-last
std::vector<ErrorAtStep> power_law(double factor, double order, int first, int last) {
    std::vector<ErrorAtStep> errors;
    for (int n = first; n <= last; ++n) {
        const double step = std::pow(2.0, -n);
        errors.push_back({step, factor * std::pow(step, order)});
    }
    return errors;
}

TEST(OrderFit, IsTheExponent) {
    const OrderFit fit = fit_order(power_law(3.0, 2.5, 1, 8), 0.0);
    EXPECT_NEAR(fit.order, 2.5, 1e-12);
    EXPECT_EQ(fit.points, 8u);
    EXPECT_TRUE(fit.straight);
    EXPECT_EQ(fit.largest, 0.5);
    EXPECT_EQ(fit.smallest, std::pow(2.0, -8));
    EXPECT_EQ(fit.range(), "3.9e-03 to 5.0e-01 s");
}

TEST(OrderFit, LeavesOutLongStepsThatDoNotShowTheOrderYet) {
    std::vector<ErrorAtStep> errors = power_law(1.0, 2.0, 1, 8);
    errors[0].error *= 5.0;
    errors[1].error *= 2.0;
    errors[2].error = INFINITY;
    const OrderFit fit = fit_order(errors, 0.0);
    EXPECT_NEAR(fit.order, 2.0, 1e-12);
    EXPECT_EQ(fit.points, 5u);
    EXPECT_EQ(fit.largest, 1.0 / 16);
}

TEST(OrderFit, LeavesOutRoundingAtTheShortestSteps) {
    std::vector<ErrorAtStep> errors = power_law(1.0, 4.0, 1, 10);
    for (ErrorAtStep& point : errors) point.error = std::max(point.error, 1e-9);
    const OrderFit fit = fit_order(errors, 0.0);
    EXPECT_NEAR(fit.order, 4.0, 0.05);
    EXPECT_EQ(fit.smallest, std::pow(2.0, -7));
    EXPECT_NEAR(fit_order(errors, 1e-6).order, 4.0, 1e-12);
}

TEST(OrderFit, TakesThreePointsWhereFourAreNotStraight) {
    std::vector<ErrorAtStep> errors = power_law(1.0, 5.0, 1, 5);
    errors[0].error *= 2.0;
    errors[4].error *= 3.0;
    const OrderFit fit = fit_order(errors, 0.0);
    EXPECT_EQ(fit.points, 3u);
    EXPECT_NEAR(fit.order, 5.0, 1e-12);
}

TEST(OrderFit, SaysWhereNothingIsStraight) {
    std::vector<ErrorAtStep> errors;
    for (int n = 1; n <= 6; ++n) errors.push_back({std::pow(2.0, -n), std::pow(2.0, -n * n)});
    EXPECT_FALSE(fit_order(errors, 0.0).straight);
    EXPECT_EQ(fit_order(errors, 0.0).points, 6u);
    EXPECT_TRUE(std::isnan(fit_order({}, 0.0).order));
    EXPECT_EQ(fit_order(power_law(1.0, 2.0, 1, 9), 1.0).points, 0u);
}

TEST(HangingMasses, MoveAsTheClosedFormHasIt) {
    Specimen specimen(hanging_masses());
    const ParticleState<double> state = hanging_solution(specimen, 0.3);
    Vec3Array<double> a(state.x.size());
    specimen.system().acceleration(0.3, state.x.view(), state.v.view(), a.view());
    // x'' = -g cos(omega t)
    EXPECT_NEAR(a[specimen.cloth().slot(4)].y, -9.81 * std::cos(1.5), 1e-12);
    EXPECT_NEAR(a[specimen.cloth().slot(5)].y, -9.81 * std::cos(1.5), 1e-12);
}

TEST(MeasureErrors, HalvesStepsUntilItIsEnough) {
    Specimen specimen(hanging_masses());
    const ParticleState<double> start = hanging_solution(specimen, 0.0),
                                end = hanging_solution(specimen, hanging_end_time);
    const Errors errors =
        measure_errors(specimen, "rk4", {start, end}, {16, 4096, false}, 1e-8, no_watch);
    ASSERT_EQ(errors.points.size(), 5u);  // 16 to 256 steps
    EXPECT_GT(errors.points[3].x, 1e-8);
    EXPECT_LE(errors.points[4].x, 1e-8);
    EXPECT_EQ((StepCounts{32, 128, true}.all()), (std::vector<std::size_t>{32, 48, 64, 96, 128}));
    const Errors read = errors_from_json(nlohmann::json::parse(errors_to_json(errors).dump()));
    EXPECT_EQ(read.points[4].x, errors.points[4].x);
    EXPECT_EQ(read.points[4].steps, 256u);
}

TEST(MeasureErrors, KeepsWhyAFlightFailed) {
    Specimen specimen(moving_sheet(false));
    const ParticleState<double> start = specimen.start();
    ParticleState<double> end = start;
    end.time = 20.0;
    const Errors errors =
        measure_errors(specimen, "forward-euler", {start, end}, {64, 64, false}, 0.0, no_watch);
    EXPECT_NE(errors.failure().find("diverged"), std::string::npos);
    const Errors read = errors_from_json(nlohmann::json::parse(errors_to_json(errors).dump()));
    EXPECT_TRUE(std::isinf(read.points[0].x));
    EXPECT_EQ(read.failure(), errors.failure());
}

TEST(OrderPlot, HasALineAMethodAndSlopes) {
    const std::vector<ErrorAtStep> errors = power_law(1.0, 2.0, 1, 5);
    const std::vector<MethodErrors> methods{{"verlet", errors, fit_order(errors, 0.0)}};
    const Plot plot = order_plot("id", "title", "error [m]", methods);
    EXPECT_TRUE(plot.log_x && plot.log_y);
    ASSERT_EQ(plot.series.size(), 3u);  // the method, slopes 1 and 2
    EXPECT_EQ(plot.series[0].look, "verlet");
    EXPECT_EQ(plot.series[2].look, "neutral");
    EXPECT_NE(plot.text.find("verlet 2.00"), std::string::npos);
}

// A small sheet in free flight about a corner: every method, on all four problems.
SceneDescription small_scene() {
    SceneDescription scene = bare_sheet(5, 4);
    scene.forces.gravity = {0.0, -9.81, 2.0};
    scene.pins = {{EdgeSelection::top_left, {}}};
    return scene;
}

// One of each kind where all would take too long.
std::vector<std::string> measured_methods() {
    if (!test::sanitized) return {};
    return {"verlet", "rk4", "yoshida4", "dopri5", "sdirk2", "xpbd"};
}

TEST(OrderExperiment, ConfirmsEveryMethod) {
    TemporaryStudy study(small_scene(), quick_study(measured_methods()));
    const Section section = measure_order(study.laboratory());
    const Table& orders = table_of(section, "orders");
    ASSERT_EQ(orders.rows.size(), study.laboratory().methods().size());
    ASSERT_EQ(orders.columns.size(), 7u);
    for (const std::vector<Cell>& row : orders.rows) {
        const std::string& method = std::get<std::string>(row[0]);
        for (const std::size_t problem : {3u, 4u, 5u, 6u}) {
            const std::size_t stated = problem == 5 ? 2 : 1;
            EXPECT_NEAR(std::get<double>(row[problem]), std::get<double>(row[stated]), 0.1)
                << method << " on " << orders.columns[problem].name;
        }
    }
    const std::size_t methods = test::sanitized ? 6 : integrator_catalogue().size();
    EXPECT_EQ(section.answer.find("On the smooth problems all " + std::to_string(methods) +
                                  " methods show the stated order"),
              0u)
        << section.answer;
    EXPECT_EQ(section.findings.size(), orders.rows.size());
    EXPECT_TRUE(section.skipped.empty());
}

TEST(OrderExperiment, GivesTheSameAgain) {
    const std::vector<std::string> methods{"velocity-verlet", "dopri5", "bdf2"};
    TemporaryStudy one(small_scene(), quick_study(methods, 2));
    TemporaryStudy other(small_scene(), quick_study(methods, 1));
    const Section first = measure_order(one.laboratory());
    const Section again = measure_order(one.laboratory());  // from what was kept
    const Section anew = measure_order(other.laboratory());
    EXPECT_EQ(first.answer, again.answer);
    EXPECT_EQ(first.answer, anew.answer);
    for (const char* id : {"fits-moving-sheet", "fits-scene"}) {
        EXPECT_EQ(table_of(first, id).rows, table_of(again, id).rows);
        EXPECT_EQ(table_of(first, id).rows, table_of(anew, id).rows);
    }
}

TEST(OrderExperiment, SaysWhereNothingMoves) {
    SceneDescription scene = small_scene();
    scene.forces.gravity = {};
    TemporaryStudy study(scene, quick_study({"rk4"}));
    const Section section = measure_order(study.laboratory());
    EXPECT_NE(section.answer.find("on the scene it could not be measured: nothing moves in it."),
              std::string::npos);
    EXPECT_THROW((void)table_of(section, "fits-scene"), std::out_of_range);
    EXPECT_TRUE(section.findings.empty());
}

// Free fall: all but the methods of first order are exact.
TEST(OrderExperiment, SaysWhereAMethodIsExact) {
    SceneDescription scene = small_scene();
    scene.pins.clear();
    TemporaryStudy study(scene, quick_study({"symplectic-euler", "verlet", "sdirk2"}));
    const Section section = measure_order(study.laboratory());
    const Table& fits = table_of(section, "fits-scene");
    EXPECT_NEAR(std::get<double>(fits.rows[0][2]), 1.0, 0.01);
    for (const std::size_t row : {1u, 2u}) {
        EXPECT_EQ(std::get<std::string>(fits.rows[row].back()), "no error above the reference's");
    }
    EXPECT_EQ(section.answer.find("nan"), std::string::npos);
}

TEST(OrderProblems, KnowWhatIsDamped) {
    EXPECT_FALSE(has_damping(small_scene()));
    EXPECT_TRUE(has_damping(moving_sheet(true)));
    const std::vector<OrderProblem> problems = order_problems(moving_sheet(true));
    const IntegratorInfo& yoshida = *find_integrator("yoshida4");
    EXPECT_EQ(problems[0].stated(yoshida), 4);
    EXPECT_EQ(problems[2].stated(yoshida), 1);
    EXPECT_EQ(problems[3].stated(yoshida), 1);
}

}  // namespace
}  // namespace weft::lab
