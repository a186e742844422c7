// The experiment "local-error": the error of a single step, and the paper's table of it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lab/experiment.h"
#include "lab/order/convergence.h"
#include "lab/order/order_plot.h"
#include "lab/order/order_problems.h"
#include "lab/order/printed_errors.h"
#include "lab/reference.h"
#include "lab/scene_stretch.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

constexpr double as_stated = 0.1;          // an order is as stated within so much
constexpr double tolerance_share = 1e-14;  // of the reference, of the cloth's size

// Where steps start, and where each of them should end.
struct Steps {
    ParticleState<double> start;
    std::vector<ParticleState<double>> ends;
    double limit = 0.0;  // scene_limit() [s]
    double exact = 0.0;  // error of the ends [m]
    std::size_t triangles = 0, edge_on = 0;
    std::string failure;

    [[nodiscard]] double length(std::size_t n) const { return ends[n].time - start.time; }
};

constexpr int longest_step = -3, shortest_step = 13;

// From 2.8 limits on (one step is no question of stability), each 1/sqrt 2 of the last; of large
// cloths half as many.
std::vector<double> step_lengths(double limit, std::size_t particles) {
    const bool large = particles > 10'000;
    std::vector<double> lengths;
    for (int n = longest_step; n <= shortest_step; ++n) {
        if (large && n % 2 != 0) continue;
        lengths.push_back(limit * std::pow(2.0, -0.5 * n));
    }
    return lengths;
}

nlohmann::json measure_ends(const SceneDescription& scene, bool quick, const Watch& watch) {
    Specimen specimen(scene);
    const SceneStretch stretch = find_scene_stretch(specimen, quick, watch);
    nlohmann::json json = stretch_to_json(specimen.cloth(), stretch);
    if (!stretch.failure.empty()) return json;
    const double size = specimen.cloth().rest_diagonal();
    json["exact"] = tolerance_share * size;
    json["ends"] = nlohmann::json::array();
    for (const double dt : step_lengths(stretch.limit, specimen.particle_count())) {
        const Reference reference = reference_solution(
            specimen, stretch.start, stretch.start.time + dt, tolerance_share * size, watch);
        json["ends"].push_back(state_to_json(specimen.cloth(), reference.state));
        json["exact"] = std::max(json["exact"].get<double>(), reference.error);
    }
    return json;
}

Steps steps_from_json(const SceneDescription& scene, const nlohmann::json& json) {
    const ClothModel cloth = build_cloth(scene);
    const SceneStretch stretch = stretch_from_json(cloth, json);
    Steps steps{stretch.start,  {}, stretch.limit, 0.0, stretch.triangles, stretch.edge_on,
                stretch.failure};
    if (!steps.failure.empty()) return steps;
    for (const nlohmann::json& end : json.at("ends")) {
        steps.ends.push_back(state_from_json(cloth, end));
    }
    steps.exact = json.at("exact").get<double>();
    return steps;
}

Errors measure_steps(const SceneDescription& scene, const Steps& steps, std::string_view method,
                     const Watch& watch) {
    Specimen specimen(scene);
    Errors errors;
    for (const ParticleState<double>& end : steps.ends) {
        const double dt = end.time - steps.start.time;
        Errors one = measure_errors(specimen, method, {steps.start, end}, {1, 1}, 0.0, watch);
        one.points.front().step = dt;
        errors.points.push_back(one.points.front());
    }
    return errors;
}

// What a step puts wrong, in metres: the position, and the velocity times the limit.
std::vector<ErrorAtStep> in_metres(const Errors& errors, double limit) {
    std::vector<ErrorAtStep> sums;
    for (const Errors::Point& point : errors.points) {
        sums.push_back({point.step, std::hypot(point.x, limit * point.v)});
    }
    return sums;
}

struct Measured {
    std::string_view method;
    int expected = 0;  // one more than the order it states for the scene
    Errors errors;
    std::vector<ErrorAtStep> sums;
    OrderFit fit;

    [[nodiscard]] bool confirmed() const {
        return fit.points > 0 && std::abs(fit.order - expected) <= as_stated;
    }
};

Measured fitted(const SceneDescription& scene, const Steps& steps, std::string_view method,
                Errors errors) {
    const IntegratorInfo& info = *find_integrator(method);
    Measured measured{method,
                      1 + (has_damping(scene) ? info.damped_order : info.order),
                      std::move(errors),
                      {},
                      {}};
    measured.sums = in_metres(measured.errors, steps.limit);
    measured.fit = fit_order(measured.sums, error_floor(steps.exact, info));
    return measured;
}

std::string note(const Steps& steps, const Measured& measured) {
    if (measured.fit.points == 0) {
        const std::string failure = measured.errors.failure();
        return failure.empty() ? "no error above the reference's" : failure;
    }
    std::string text;
    if (measured.method == "bdf2") text = "a first step, which is one of sdirk2";
    if (measured.confirmed()) return text;
    if (!text.empty()) text += "; ";
    if (!measured.fit.straight) {
        return text +
               (measured.fit.points <= 3 ? "errors hardly above rounding" : "no straight range");
    }
    if (steps.edge_on > 0 && measured.fit.order < measured.expected) {
        return text + "the air's force has a kink where it meets triangles edge-on";
    }
    return text + "straight, but steps are not yet short enough";
}

// The step of half the limit, which the table shows the error of.
std::size_t shown_step(const Steps& steps) {
    std::size_t n = 0;
    while (n + 1 < steps.ends.size() && steps.length(n) > 0.51 * steps.limit) ++n;
    return n;
}

Table fits_table(const Steps& steps, const std::vector<Measured>& methods) {
    const std::size_t shown = shown_step(steps);
    Table table{"fits",
                "One step on the scene: a row is a method. A method of order p should show p + 1; "
                "the slope is that over the steps from shortest to longest.",
                {{"method", 0},
                 {"p + 1"},
                 {"measured", 3},
                 {"shortest step [s]", 2},
                 {"longest step [s]", 2},
                 {"points"},
                 {fmt::format("error of a step of {:.2g} s [m]", steps.length(shown)), 2},
                 {"note", 0}},
                {}};
    for (const Measured& measured : methods) {
        const OrderFit& fit = measured.fit;
        const bool found = fit.points > 0;
        table.rows.push_back({std::string(measured.method), static_cast<double>(measured.expected),
                              found ? Cell{fit.order} : Cell{std::string("none")},
                              found ? Cell{fit.smallest} : Cell{},
                              found ? Cell{fit.largest} : Cell{}, static_cast<double>(fit.points),
                              measured.sums[shown].error, note(steps, measured)});
    }
    return table;
}

std::string scene_text(const Steps& steps, bool wind) {
    std::string text = fmt::format(
        "One step on the scene, from a state in motion at {:.4g} s, of lengths up to 2.8 times the "
        "stable step of {:.3g} s. The error counts positions, and velocities times that stable "
        "step, so that both are in metres. The reference is exact to {:.1g} m.",
        steps.start.time, steps.limit, steps.exact);
    if (wind) {
        text += fmt::format(" Within 8 such steps the air meets {} of {} triangles edge-on.",
                            steps.edge_on, steps.triangles);
    }
    return text;
}

void add_scene_blocks(const SceneDescription& scene, const Steps& steps,
                      const std::vector<Measured>& methods, Section& section) {
    if (!steps.failure.empty()) {
        section.blocks.emplace_back(
            Paragraph{"The scene itself could not be measured on: " + steps.failure + "."});
        return;
    }
    section.blocks.emplace_back(Paragraph{scene_text(steps, scene.wind.has_value())});
    std::vector<MethodErrors> lines;
    for (const Measured& measured : methods) {
        lines.push_back({measured.method, measured.sums, measured.fit});
    }
    section.blocks.emplace_back(
        order_plot("error-of-one-step", "Error of one step", "rms error of one step [m]", lines));
    section.blocks.emplace_back(fits_table(steps, methods));
}

std::string scene_answer(const std::vector<Measured>& methods) {
    std::string others;
    std::size_t confirmed = 0, exact = 0;
    for (const Measured& measured : methods) {
        if (measured.confirmed()) {
            ++confirmed;
        } else if (measured.fit.points == 0) {
            ++exact;
        } else {
            others += fmt::format("{}{} {:.2f} for {}", others.empty() ? "" : ", ", measured.method,
                                  measured.fit.order, measured.expected);
        }
    }
    std::string text = fmt::format(
        "on the scene {} of {} methods show the local order p + 1 "
        "within {}",
        confirmed, methods.size(), as_stated);
    if (!others.empty()) text += " (not " + others + ")";
    if (exact > 0)
        text += fmt::format(", {} {} as exact as the reference", exact, exact == 1 ? "is" : "are");
    return text;
}

// The trials of the second batch: the paper's table, then a method each.
std::vector<Trial> step_trials(const Laboratory& laboratory, const Steps& steps,
                               const nlohmann::json& reference) {
    std::vector<Trial> trials = printed_errors_trials(reference);
    for (const std::string_view method : laboratory.methods()) {
        if (!steps.failure.empty()) break;
        trials.push_back({fmt::format("one step of {}", method),
                          [&scene = laboratory.scene(), &steps, method](const Watch& watch) {
                              return errors_to_json(measure_steps(scene, steps, method, watch));
                          }});
    }
    return trials;
}

}  // namespace

Section measure_local_error(Laboratory& laboratory) {
    const SceneDescription& scene = laboratory.scene();
    const std::vector<Trial> references{
        {"ends of steps",
         [&](const Watch& watch) { return measure_ends(scene, laboratory.quick(), watch); }, 3.0},
        printed_errors_reference()};
    const std::vector<nlohmann::json> ends = laboratory.run(references);
    const Steps steps = steps_from_json(scene, ends[0]);
    const std::vector<nlohmann::json> found =
        laboratory.run(step_trials(laboratory, steps, ends[1]));
    const std::size_t printed =
        steps.failure.empty() ? found.size() - laboratory.methods().size() : found.size();
    std::vector<Measured> methods;
    for (std::size_t n = printed; n < found.size(); ++n) {
        methods.push_back(
            fitted(scene, steps, laboratory.methods()[n - printed], errors_from_json(found[n])));
    }
    Section section;
    section.method =
        "One step is made from a known state, and where it ends is compared with the reference. A "
        "method of order p errs by dt^(p + 1) in one step; the errors of all steps together then "
        "grow like dt^p. As in the experiment on the order, slopes are fitted where the line is "
        "straight. The table of the paper is measured on the paper's own sheet, at the step that "
        "its numbers imply.";
    const PrintedErrors table = printed_errors(std::span(found).first(printed));
    section.blocks.emplace_back(table.table);
    section.blocks.emplace_back(Paragraph{table.text});
    add_scene_blocks(scene, steps, methods, section);
    section.answer = table.answer + (methods.empty() ? "." : "; " + scene_answer(methods) + ".");
    for (const Measured& measured : methods) {
        if (measured.fit.points == 0) continue;
        section.findings.push_back({fmt::format("local order of {} on the scene", measured.method),
                                    measured.fit.order, ""});
    }
    return section;
}

}  // namespace weft::lab
