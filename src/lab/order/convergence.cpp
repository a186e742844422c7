#include "lab/order/convergence.h"

#include <cmath>
#include <limits>

#include "weft/integrators.h"

namespace weft::lab {

FlightPlan exact_plan(std::string_view method, double time_step, std::size_t steps) {
    FlightPlan plan{method, time_step, steps, {}, {}};
    if (find_integrator(method)->kind == IntegratorKind::adaptive) plan.tolerance = 1e6;
    if (method == "xpbd") plan.iterations = 20;
    if (method == "vbd") plan.iterations = 40;
    if (method == "projective-dynamics") {
        plan.iterations = 200;
        plan.tolerance = 1e-12;
    }
    return plan;
}

std::vector<ErrorAtStep> Errors::of_positions() const {
    std::vector<ErrorAtStep> errors;
    for (const Point& point : points) errors.push_back({point.step, point.x});
    return errors;
}

std::vector<ErrorAtStep> Errors::of_velocities() const {
    std::vector<ErrorAtStep> errors;
    for (const Point& point : points) errors.push_back({point.step, point.v});
    return errors;
}

std::string Errors::failure() const {
    for (auto point = points.rbegin(); point != points.rend(); ++point) {
        if (!point->failure.empty()) return point->failure;
    }
    return {};
}

std::vector<std::size_t> StepCounts::all() const {
    std::vector<std::size_t> counts;
    for (std::size_t steps = first; steps > 0 && steps <= most; steps *= 2) {
        counts.push_back(steps);
        if (halfway && steps < most) counts.push_back(steps / 2 * 3);
    }
    return counts;
}

Errors measure_errors(Specimen& specimen, std::string_view method, const KnownEnd& problem,
                      const StepCounts& counts, double enough, const Watch& watch) {
    const double length = problem.end.time - problem.start.time;
    Errors errors;
    for (const std::size_t steps : counts.all()) {
        const double step = length / static_cast<double>(steps);
        const Flight flight = fly(specimen, exact_plan(method, step, steps), problem.start, watch);
        Errors::Point point{steps, step, 0.0, 0.0, flight.failure};
        if (flight.ok()) {
            point.x = rms_distance(specimen.cloth(), flight.state, problem.end);
            point.v = rms_difference(specimen.cloth(), flight.state.v.view(), problem.end.v.view());
        } else {
            point.x = point.v = std::numeric_limits<double>::infinity();
        }
        errors.points.push_back(point);
        if (point.x <= enough) break;
    }
    return errors;
}

nlohmann::json errors_to_json(const Errors& errors) {
    nlohmann::json json = nlohmann::json::array();
    for (const Errors::Point& point : errors.points) {
        nlohmann::json row = {{"steps", point.steps}, {"dt", point.step}};
        if (point.failure.empty()) {
            row["x"] = point.x;
            row["v"] = point.v;
        } else {
            row["failure"] = point.failure;
        }
        json.push_back(std::move(row));
    }
    return json;
}

Errors errors_from_json(const nlohmann::json& json) {
    constexpr double failed = std::numeric_limits<double>::infinity();
    Errors errors;
    for (const nlohmann::json& row : json) {
        errors.points.push_back({row.at("steps").get<std::size_t>(), row.at("dt").get<double>(),
                                 row.value("x", failed), row.value("v", failed),
                                 row.value("failure", "")});
    }
    return errors;
}

}  // namespace weft::lab
