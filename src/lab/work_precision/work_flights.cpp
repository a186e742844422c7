#include "lab/work_precision/work_flights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "weft/integrators.h"

namespace weft::lab {

namespace {

constexpr double accurate_enough = 5e-5;  // of the motion
constexpr int most_points = 14;
constexpr int newton_iterations = 300, newton_iterations_quick = 100;
constexpr double longest_step = 1.0 / 15.0;  // of methods that nothing limits [s]

// Rough work of each kind for one particle; about nanoseconds. Small cloths take as long as if they
// had some more.
constexpr std::size_t overhead_particles = 150;
constexpr double evaluation_work = 15.0, newton_work = 400.0, linear_work = 60.0;
constexpr double xpbd_work = 100.0, vbd_work = 250.0, projective_work = 500.0;

// Most work of one flight, and of all.
struct Budget {
    double flight = 0.0, all = 0.0;
};

Budget budget_of(bool quick) {
    return quick ? Budget{1e8, 4e8} : Budget{3e9, 1e10};
}

double work_of(std::string_view method, const WorkPoint& point, std::size_t particles) {
    const double sweep = method == "xpbd"                  ? xpbd_work
                         : method == "vbd"                 ? vbd_work
                         : method == "projective-dynamics" ? projective_work
                                                           : newton_work;
    return static_cast<double>(particles + overhead_particles) *
           (evaluation_work * static_cast<double>(point.evaluations) +
            sweep * static_cast<double>(point.newton_iterations) +
            linear_work * static_cast<double>(point.linear_iterations));
}

double first_step(Specimen& specimen, const IntegratorInfo& info, double length) {
    if (info.kind != IntegratorKind::explicit_steps) return std::min(longest_step, length / 4.0);
    const double own = specimen.modes().stable_step(info.name);
    const double common = specimen.modes().stable_step("velocity-verlet");
    return std::min(0.95 * (own < 0.25 * common ? common : own), length / 4.0);
}

// The flight number `level` of a series.
FlightPlan plan_of(Specimen& specimen, const WorkPlan& work, const WorkStretch& stretch,
                   int level) {
    const IntegratorInfo& info = *find_integrator(work.method);
    const double length = stretch.length();
    if (info.kind == IntegratorKind::adaptive) {
        constexpr std::size_t parts = 4;  // no step is longer
        return {info.name, length / parts, parts, 1e-2 * stretch.motion * std::pow(0.1, level), {}};
    }
    const double first = std::ceil(length / first_step(specimen, info, length) - 1e-9);
    const auto steps = static_cast<std::size_t>(first) << level;
    FlightPlan plan{info.name, length / static_cast<double>(steps), steps, {}, {}};
    if (info.kind == IntegratorKind::implicit) {
        // As the local error of second order, lest what is left unsolved outweigh it.
        plan.tolerance =
            std::max(1e-6 * specimen.cloth().rest_diagonal() * std::pow(0.125, level), 1e-12);
        plan.iterations = work.quick ? newton_iterations_quick : newton_iterations;
    }
    return plan;
}

void count(const IntegratorInfo& info, const Flight& flight, WorkPoint& point) {
    point.steps = flight.counts.steps > 0 ? flight.counts.steps : flight.steps;
    point.evaluations = info.kind == IntegratorKind::explicit_steps
                            ? flight.steps * static_cast<std::size_t>(info.evaluations)
                            : flight.counts.evaluations;
    point.newton_iterations = flight.counts.newton_iterations;
    point.linear_iterations = flight.counts.linear_iterations;
}

// Short flights are repeated: times vary.
WorkPoint measure_point(Specimen& specimen, const IntegratorInfo& info, const FlightPlan& plan,
                        const WorkStretch& stretch, const Watch& watch) {
    constexpr double enough = 0.03;  // [s]
    constexpr int most_flights = 5;
    Flight flight = fly(specimen, plan, stretch.start, watch);
    double seconds = flight.seconds, sum = seconds;
    for (int n = 1; n < most_flights && flight.ok() && sum < enough; ++n) {
        const double again = fly(specimen, plan, stretch.start, watch).seconds;
        seconds = std::min(seconds, again);
        sum += again;
    }
    WorkPoint point;
    point.tolerance = info.kind == IntegratorKind::adaptive ? *plan.tolerance : 0.0;
    point.failure = flight.failure;
    count(info, flight, point);
    point.step = info.kind == IntegratorKind::adaptive
                     ? stretch.length() / static_cast<double>(std::max<std::size_t>(point.steps, 1))
                     : plan.time_step;
    point.ms = 1e3 * seconds;
    point.error = flight.ok() ? rms_distance(specimen.cloth(), flight.state, stretch.end)
                              : std::numeric_limits<double>::infinity();
    return point;
}

}  // namespace

WorkSeries measure_work(Specimen& specimen, const WorkPlan& plan, const WorkStretch& stretch,
                        const Watch& watch) {
    const IntegratorInfo& info = *find_integrator(plan.method);
    const Budget budget = budget_of(plan.quick);
    const double ratio =
        info.kind == IntegratorKind::adaptive ? std::pow(10.0, 1.0 / info.order) : 2.0;
    WorkSeries series;
    double all = 0.0, next = 0.0;
    for (int level = 0; level < most_points; ++level) {
        series.bounded = next > budget.flight || all + next > budget.all;
        if (series.bounded) break;
        const FlightPlan flight = plan_of(specimen, plan, stretch, level);
        series.points.push_back(measure_point(specimen, info, flight, stretch, watch));
        const WorkPoint& point = series.points.back();
        if (point.error <= accurate_enough * stretch.motion) break;
        const double work = work_of(plan.method, point, specimen.particle_count());
        all += work;
        // A flight that failed early says little of the next.
        next = point.ok() ? ratio * work : 0.0;
    }
    return series;
}

nlohmann::json work_series_to_json(const WorkSeries& series) {
    nlohmann::json points = nlohmann::json::array();
    for (const WorkPoint& point : series.points) {
        nlohmann::json row = {{"step", point.step},
                              {"tolerance", point.tolerance},
                              {"steps", point.steps},
                              {"evaluations", point.evaluations},
                              {"newton_iterations", point.newton_iterations},
                              {"linear_iterations", point.linear_iterations},
                              {"ms, varies", point.ms}};
        if (point.ok()) {
            row["error"] = point.error;
        } else {
            row["failure"] = point.failure;
        }
        points.push_back(std::move(row));
    }
    return {{"points", std::move(points)}, {"bounded", series.bounded}};
}

WorkSeries work_series_from_json(const nlohmann::json& json) {
    WorkSeries series;
    series.bounded = json.at("bounded").get<bool>();
    for (const nlohmann::json& row : json.at("points")) {
        const auto number = [&](const char* key) { return row.at(key).get<std::size_t>(); };
        series.points.push_back({row.at("step").get<double>(), row.at("tolerance").get<double>(),
                                 number("steps"), number("evaluations"),
                                 number("newton_iterations"), number("linear_iterations"),
                                 row.value("error", std::numeric_limits<double>::infinity()),
                                 row.at("ms, varies").get<double>(), row.value("failure", "")});
    }
    return series;
}

}  // namespace weft::lab
