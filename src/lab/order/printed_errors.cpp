#include "lab/order/printed_errors.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "lab/order/convergence.h"
#include "lab/reference.h"
#include "lab/seed_sheet.h"
#include "lab/trajectory.h"

namespace weft::lab {

namespace {

constexpr double tolerance = 1e-12;     // of the references [m]
constexpr std::size_t some_steps = 20;  // soon after the start
constexpr std::size_t all_steps = 62;   // the whole number that comes next to a second
constexpr double one_step_from = 1.0;   // [s]

struct Row {
    std::string_view method;
    std::string_view name;  // in the paper
    int power;              // of dt that is printed
    double printed;
};

constexpr std::array<Row, 3> rows{{{"forward-euler", "Forward Euler", 1, 1.6e-2},
                                   {"verlet", "Verlet", 2, 2.56e-4},
                                   {"rk3", "R-K", 3, 4.096e-6}}};

double time_of(std::size_t steps) {
    return static_cast<double>(steps) * seed_time_step;
}

nlohmann::json measure_reference(const Watch& watch) {
    Specimen specimen(seed_scene({}));
    ParticleState<double> state = specimen.start();
    nlohmann::json json;
    const auto go_on = [&](const char* key, double time) {
        state = reference_solution(specimen, state, time, tolerance, watch).state;
        json[key] = state_to_json(specimen.cloth(), state);
    };
    go_on("soon", time_of(some_steps));
    go_on("end", time_of(all_steps));
    go_on("moving", one_step_from);
    go_on("after", one_step_from + seed_time_step);
    return json;
}

nlohmann::json flight_error(Specimen& specimen, const Row& row, const KnownEnd& known,
                            std::size_t steps, const Watch& watch) {
    const Flight flight =
        fly(specimen, exact_plan(row.method, seed_time_step, steps), known.start, watch);
    if (!flight.ok()) return {{"blew up", flight.state.time}};
    return {{"x", rms_distance(specimen.cloth(), flight.state, known.end)},
            {"v", rms_difference(specimen.cloth(), flight.state.v.view(), known.end.v.view())},
            {"way", rms_distance(specimen.cloth(), known.start, known.end)}};
}

nlohmann::json measure_row(const Row& row, const nlohmann::json& reference, const Watch& watch) {
    Specimen specimen(seed_scene({}));
    const auto state = [&](const char* key) {
        return state_from_json(specimen.cloth(), reference.at(key));
    };
    const ParticleState<double> moving = state("moving"), after = state("after");
    const ParticleState<double> start = specimen.start(), soon = state("soon"), end = state("end");
    return {{"one", flight_error(specimen, row, {moving, after}, 1, watch)},
            {"some", flight_error(specimen, row, {start, soon}, some_steps, watch)},
            {"all", flight_error(specimen, row, {start, end}, all_steps, watch)}};
}

bool blew_up(const nlohmann::json& error) {
    return error.contains("blew up");
}

Cell absolute(const nlohmann::json& error, const char* key) {
    if (blew_up(error)) {
        return fmt::format("blew up by {:.3g} s", error.at("blew up").get<double>());
    }
    return error.at(key).get<double>();
}

Cell relative(const nlohmann::json& error) {
    if (blew_up(error)) return {};
    return error.at("x").get<double>() / error.at("way").get<double>();
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (std::size_t n = 0; n < parts.size(); ++n) {
        if (n > 0) text += n + 1 == parts.size() ? " and " : ", ";
        text += parts[n];
    }
    return text;
}

// "by 0.0018 m (forward-euler) and 0.00018 m (verlet)", and who blew up.
std::string errors_text(std::span<const nlohmann::json> results, const char* key) {
    std::vector<std::string> errors, others;
    for (std::size_t n = 0; n < rows.size(); ++n) {
        const nlohmann::json& error = results[n].at(key);
        if (blew_up(error)) {
            others.push_back(fmt::format("{} blew up by {:.2g} s", rows[n].method,
                                         error.at("blew up").get<double>()));
        } else {
            errors.push_back(
                fmt::format("{:.2g} m ({})", error.at("x").get<double>(), rows[n].method));
        }
    }
    std::string text = errors.empty() ? "no finite way" : "by " + joined(errors);
    if (!others.empty()) text += ", while " + joined(others);
    return text;
}

Table empty_table() {
    const auto after = [](std::size_t steps, const char* what) {
        return Column{fmt::format("after {:.3g} s: {}", time_of(steps), what), 3};
    };
    return {"printed-errors",
            fmt::format("The comparison's table 1 beside what is measured on its sheet with dt = "
                        "{} s: a row is a method. Errors are root mean squares over the particles.",
                        seed_time_step),
            {{"in the paper", 0},
             {"method here", 0},
             {"printed local error", 4},
             {"what it is", 0},
             {"dt to that power", 4},
             {"one step: position [m]", 3},
             {"one step: velocity [m/s]", 3},
             {"one step: of the way made", 3},
             after(some_steps, "position [m]"),
             after(some_steps, "of the way made"),
             after(all_steps, "position [m]"),
             after(all_steps, "of the way made")},
            {}};
}

Table filled_table(std::span<const nlohmann::json> results) {
    Table table = empty_table();
    for (std::size_t n = 0; n < rows.size(); ++n) {
        const Row& row = rows[n];
        const nlohmann::json &one = results[n].at("one"), &some = results[n].at("some"),
                             &all = results[n].at("all");
        table.rows.push_back({std::string(row.name), std::string(row.method), row.printed,
                              fmt::format("dt^{}", row.power), std::pow(seed_time_step, row.power),
                              absolute(one, "x"), absolute(one, "v"), relative(one),
                              absolute(some, "x"), relative(some), absolute(all, "x"),
                              relative(all)});
    }
    return table;
}

}  // namespace

Trial printed_errors_reference() {
    return {fmt::format("reference of the paper's sheet after {}, {} and {} steps of {} s",
                        some_steps, all_steps, 1, seed_time_step),
            measure_reference, 1.0};
}

std::vector<Trial> printed_errors_trials(const nlohmann::json& reference) {
    std::vector<Trial> trials;
    for (const Row& row : rows) {
        trials.push_back(
            {fmt::format("{} on the paper's sheet dt={}", row.method, seed_time_step),
             [&row, &reference](const Watch& watch) { return measure_row(row, reference, watch); },
             0.2});
    }
    return trials;
}

PrintedErrors printed_errors(std::span<const nlohmann::json> results) {
    PrintedErrors found;
    found.table = filled_table(results);
    found.text = fmt::format(
        "The printed numbers have no unit and are exactly dt, dt^2 and dt^3 with dt = {0} s. They "
        "say how errors scale with the step, not how large they are: an error is dt^(p + 1) in one "
        "step, and dt^p at the end of many, times a factor that depends on the motion and has a "
        "unit. The sheet is the paper's: 40 x 40 particles, 20 m x 20 m, every spring of 800 N/m, "
        "both top corners held; the paper does not print the mass, here it is 1 kg a particle. The "
        "one step starts from the motion at {1:g} s, the flights of {2} and {3} steps from rest. "
        "Of the way made: the error over the way of the particles in that time.",
        seed_time_step, one_step_from, some_steps, all_steps);
    found.answer = fmt::format(
        "The printed 1.6e-2, 2.56e-4 and 4.096e-6 are dt, dt^2 and dt^3 for dt = {} s, not "
        "measurements: on the paper's sheet one such step puts the particles wrong {}, and {} "
        "steps put them wrong {}",
        seed_time_step, errors_text(results, "one"), all_steps, errors_text(results, "all"));
    return found;
}

}  // namespace weft::lab
