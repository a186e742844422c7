// The experiment "stability": how long a step may be, in theory and in flight.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "lab/experiment.h"
#include "lab/flight_cost.h"
#include "lab/stability/stability_figures.h"
#include "lab/stability/stability_trials.h"
#include "simulation/method_choice.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

// Steps for methods without a limit, in units of velocity-verlet's.
std::vector<double> beyond_factors(bool quick) {
    return quick ? std::vector{10.0, 100.0} : std::vector{10.0, 100.0, 1000.0};
}

// What is done with a method.
struct Plan {
    const IntegratorInfo* info = nullptr;
    double predicted = 0.0;  // [s]
    Search search;
    std::size_t first_trial = 0;  // of its one, or one for each factor

    [[nodiscard]] bool has_limit() const {
        return info->kind == IntegratorKind::explicit_steps && predicted > 0.0;
    }
    [[nodiscard]] bool never_stable() const {
        return info->kind == IntegratorKind::explicit_steps && !(predicted > 0.0);
    }
    [[nodiscard]] bool goes_beyond() const {
        return info->kind == IntegratorKind::implicit || info->kind == IntegratorKind::by_springs;
    }
};

class StabilityExperiment {
public:
    explicit StabilityExperiment(Laboratory& laboratory)
        : laboratory_(laboratory),
          cloth_(laboratory.scene()),
          factors_(beyond_factors(laboratory.quick())) {}

    Section run();

private:
    void plan();
    void add_limit(Plan& plan);
    // Of the forces, that a flight is worth.
    [[nodiscard]] double flight_evaluations() {
        const double cost = evaluation_cost(cloth_.specimen().scene());
        return (laboratory_.quick() ? 8e6 : 6e7) / cost /
               static_cast<double>(cloth_.specimen().particle_count());
    }
    void gather();
    [[nodiscard]] std::optional<double> step_of_scene();
    void add_blocks(Section& section);
    [[nodiscard]] Table limit_table() const;
    [[nodiscard]] std::vector<Cell> limit_row(const Plan& plan) const;
    [[nodiscard]] std::vector<Cell> row_without_limit(const Plan& plan) const;
    [[nodiscard]] Table beyond_table() const;
    [[nodiscard]] std::string method_text() const;
    [[nodiscard]] std::string answer() const;
    [[nodiscard]] std::string answer_of_limits() const;
    [[nodiscard]] std::string answer_of_the_rest() const;
    void add_findings(Section& section) const;
    [[nodiscard]] const nlohmann::json& result(const Plan& plan, std::size_t n = 0) const {
        return results_[plan.first_trial + n];
    }
    [[nodiscard]] std::optional<double> observed(const Plan& plan) const {
        const nlohmann::json& found = result(plan);
        if (!found.at("found").get<bool>()) return std::nullopt;
        return 0.5 * (found.at("stable").get<double>() + found.at("unstable").get<double>());
    }

    Laboratory& laboratory_;
    RestingCloth cloth_;
    std::vector<double> factors_;
    double unit_ = 0.0;     // the limit of velocity-verlet [s]
    double growing_ = 0.0;  // the step at which methods of no limit are shown to grow [s]
    std::size_t steps_beyond_ = 0;
    std::vector<Plan> plans_;
    std::vector<Trial> trials_;
    std::vector<nlohmann::json> results_;
    StabilityFigures figures_;
};

Section StabilityExperiment::run() {
    Section section;
    if (!(cloth_.omega() > 0.0)) {
        section.skipped =
            "No spring of this cloth holds a particle that may move, so no step is "
            "too long for any method.";
        return section;
    }
    plan();
    results_ = laboratory_.run(trials_);
    gather();
    section.method = method_text();
    add_blocks(section);
    section.answer = answer();
    add_findings(section);
    return section;
}

void StabilityExperiment::plan() {
    const bool quick = laboratory_.quick();
    unit_ = cloth_.modes().stable_step("velocity-verlet");
    growing_ = 0.1 * unit_;
    steps_beyond_ = quick ? 10 : 20;
    trials_.push_back(spectrum_trial(laboratory_.scene(), quick ? 40 : 80));
    for (const std::string_view name : laboratory_.methods()) {
        Plan plan{find_integrator(name), cloth_.modes().stable_step(name), {}, trials_.size()};
        if (plan.has_limit()) {
            add_limit(plan);
        } else if (plan.never_stable()) {
            const double rate = std::max(cloth_.predicted_rate(name, growing_), 1e-6);
            const double most = flight_evaluations() / plan.info->evaluations;
            const auto steps = static_cast<std::size_t>(
                std::min(std::clamp(8.0 / rate, 400.0, 6e4), std::max(most, 400.0)));
            trials_.push_back(growth_trial(laboratory_.scene(), name, growing_, steps));
        } else if (plan.goes_beyond()) {
            for (const double factor : factors_) {
                trials_.push_back(
                    beyond_trial(laboratory_.scene(), name, factor * unit_, steps_beyond_));
            }
        }
        plans_.push_back(plan);
    }
}

void StabilityExperiment::add_limit(Plan& plan) {
    const bool quick = laboratory_.quick();
    plan.search = cloth_.plan_search(plan.info->name, plan.predicted, flight_evaluations());
    const std::vector<double> parts =
        quick ? std::vector{0.9, 1.02, 1.1} : std::vector{0.8, 0.9, 0.98, 1.02, 1.05, 1.1, 1.2};
    trials_.push_back(
        limit_trial(laboratory_.scene(), plan.info->name, plan.predicted, plan.search, parts));
}

// What the scene is flown with; none where its method has no limit, or no step.
std::optional<double> StabilityExperiment::step_of_scene() {
    const SceneDescription& scene = laboratory_.scene();
    const std::string method =
        choose_method(scene, cloth_.specimen().cloth(), cloth_.modes()).method;
    if (find_integrator(method)->kind != IntegratorKind::explicit_steps) return std::nullopt;
    if (!scene.integrator.time_step && !(cloth_.modes().stable_step(method) > 0.0)) {
        return std::nullopt;
    }
    return 1.0 / scene.output.frames_per_second /
           static_cast<double>(steps_a_frame(scene, method, cloth_.modes()));
}

// What the figures show.
void StabilityExperiment::gather() {
    for (const nlohmann::json& mode : results_.front().at("modes")) {
        figures_.spectrum.push_back({mode.at(0).get<double>(), mode.at(1).get<double>()});
    }
    figures_.methods = laboratory_.methods();
    figures_.limiting = cloth_.modes().modes;
    figures_.limit_of_verlet = unit_;
    figures_.scene_step = step_of_scene();
    for (const Plan& plan : plans_) {
        if (!plan.has_limit()) continue;
        GrowthCurve curve{plan.info->name, plan.predicted, {}};
        for (const nlohmann::json& point : result(plan).at("curve")) {
            curve.measured.push_back({point.at(0).get<double>(), point.at(1).get<double>()});
        }
        figures_.growth.push_back(std::move(curve));
    }
}

void StabilityExperiment::add_blocks(Section& section) {
    section.blocks.emplace_back(limit_table());
    if (std::optional<Plot> plot = growth_plot(figures_)) section.blocks.emplace_back(*plot);
    if (std::optional<Plot> plot = region_plot(figures_)) section.blocks.emplace_back(*plot);
    for (Plot& plot : implicit_plots(figures_)) section.blocks.emplace_back(std::move(plot));
    if (std::ranges::any_of(plans_, &Plan::goes_beyond)) {
        section.blocks.emplace_back(beyond_table());
    }
}

std::string limit_note(const Plan& plan, const nlohmann::json& found, double ratio) {
    if (!found.at("found").get<bool>()) return "no limit near the predicted one";
    if (ratio > 1.02) return "predicted on the safe side: no mode is as little damped as supposed";
    if (ratio < 0.98) return "predicted too long";
    if (found.at("resolution").get<double>() > 0.002) {
        return fmt::format("flights cut to {} steps: seen less sharply", plan.search.steps);
    }
    return {};
}

std::vector<Cell> StabilityExperiment::limit_row(const Plan& plan) const {
    const std::optional<double> limit = observed(plan);
    const nlohmann::json& found = result(plan);
    const double ratio = limit ? *limit / plan.predicted : 0.0;
    const double evaluations = std::max(plan.info->evaluations, 1);
    const std::string note = limit_note(plan, found, ratio);
    return {std::string(plan.info->name),
            plan.predicted,
            limit ? Cell(*limit) : Cell(),
            limit ? Cell(ratio) : Cell(),
            50.0 * found.at("resolution").get<double>(),
            plan.predicted * cloth_.omega(),
            plan.predicted / evaluations,
            note.empty() ? Cell() : Cell(note)};
}

std::vector<Cell> StabilityExperiment::row_without_limit(const Plan& plan) const {
    std::string note;
    Cell predicted, measured;
    if (plan.never_stable()) {
        predicted = measured = 0.0;
        note = fmt::format(
            "stable at no step: at {:.3g} s it grows by {:.4g} % a step, predicted "
            "{:.4g} %",
            growing_, 100.0 * std::expm1(result(plan).at("rate").get<double>()),
            100.0 * std::expm1(cloth_.predicted_rate(plan.info->name, growing_)));
    } else if (plan.info->kind == IntegratorKind::adaptive) {
        note = "no limit of its own: it repeats a step that grows as one too inaccurate";
    } else {
        note = fmt::format("none; tried at up to {:g} times the limit of velocity-verlet below",
                           factors_.back());
    }
    return {std::string(plan.info->name), predicted, measured, {}, {}, {}, {}, note};
}

Table StabilityExperiment::limit_table() const {
    Table table{"limits",
                "A row is a method: the largest stable step in theory and in flight.",
                {{"Method"},
                 {"Predicted limit [s]"},
                 {"Observed limit [s]"},
                 {"Observed / predicted", 5},
                 {"Observed to within ± [%]", 2},
                 {"Predicted limit × ω_max"},
                 {"Predicted limit an evaluation [s]"},
                 {"Note"}},
                {}};
    for (const Plan& plan : plans_) {
        table.rows.push_back(plan.has_limit() ? limit_row(plan) : row_without_limit(plan));
    }
    return table;
}

Table StabilityExperiment::beyond_table() const {
    Table table{"beyond",
                fmt::format("A row is a method without a limit, at a step of so many times the "
                            "limit of velocity-verlet ({:.4g} s), for {} steps: how the nudge of "
                            "the cloth at rest changed, and how the scene itself ended.",
                            unit_, steps_beyond_),
                {{"Method"},
                 {"Step / limit of velocity-verlet"},
                 {"Step [s]"},
                 {"Nudge at the end / at the start"},
                 {"Strain of the worst spring in the scene"},
                 {"What happened"}},
                {}};
    for (const Plan& plan : plans_) {
        if (!plan.goes_beyond()) continue;
        for (std::size_t n = 0; n < factors_.size(); ++n) {
            const nlohmann::json &rest = result(plan, n), &scene = rest.at("scene");
            const std::string failed = scene.at("failure").get<std::string>(),
                              at_rest = rest.at("failure").get<std::string>();
            const bool growing = rest.at("total").get<double>() > 1.0;
            std::string note = failed.empty() ? "stays finite" : "the scene: " + failed;
            if (growing) note += "; the nudge grows";
            if (!at_rest.empty()) note += "; at rest: " + at_rest;
            table.rows.push_back(
                {std::string(plan.info->name), factors_[n], factors_[n] * unit_,
                 std::exp(rest.at("total").get<double>()),
                 scene.contains("strain") ? Cell(scene["strain"].get<double>()) : Cell(), note});
        }
    }
    return table;
}

std::string StabilityExperiment::method_text() const {
    return fmt::format(
               "Predicted: the springs are linearised at rest; the largest frequency ω_max = "
               "{:.5g} rad/s "
               "and the dampings that go with it are found iteratively, and the limit of a method "
               "is the "
               "largest step at which it amplifies none of these modes. Observed: the cloth at "
               "rest, "
               "without gravity and wind and with its pins held still, is nudged by a "
               "hundred-millionth of "
               "a spring's length (along its fastest mode, and a third as much at random) and "
               "flown in "
               "double precision. ",
               cloth_.omega()) +
           "A step counts as unstable where the amplitude, the root of the energy of springs and "
           "motion, grows ten-thousandfold, or e-fold over the second half of the flight (by a "
           "tenth "
           "where flights had to be cut short). Bisection starts between two powers of 1.05 s and "
           "knows nothing else of the prediction. Cloth in motion is stretched, and so its modes "
           "are "
           "a little faster.";
}

std::string StabilityExperiment::answer_of_limits() const {
    double lowest = 1e300, highest = 0.0, largest = 0.0;
    int count = 0, missing = 0;
    std::string_view best;
    for (const Plan& plan : plans_) {
        if (!plan.has_limit()) continue;
        ++count;
        const std::optional<double> limit = observed(plan);
        if (!limit) {
            ++missing;
            continue;
        }
        lowest = std::min(lowest, *limit / plan.predicted);
        highest = std::max(highest, *limit / plan.predicted);
        if (*limit > largest) largest = *limit, best = plan.info->name;
    }
    if (count == 0) return {};
    if (missing == count) return "No limit was observed near the predicted ones";
    std::string text = fmt::format(
        "The observed limits are {:.4f} to {:.4f} times the predicted ones for the {} methods that "
        "have one, the longest being {:.4g} s of {}",
        lowest, highest, count - missing, largest, best);
    if (missing > 0) text += fmt::format(" ({} more showed none)", missing);
    return text;
}

std::string StabilityExperiment::answer_of_the_rest() const {
    std::vector<std::string> parts, never;
    int beyond = 0, finite = 0;
    for (const Plan& plan : plans_) {
        if (plan.never_stable()) never.emplace_back(plan.info->name);
        if (!plan.goes_beyond()) continue;
        ++beyond;
        bool sound = true;
        for (std::size_t n = 0; n < factors_.size(); ++n) {
            const nlohmann::json& flown = result(plan, n);
            sound = sound && flown.at("scene").at("failure") == "" && flown.at("failure") == "";
        }
        finite += sound ? 1 : 0;
    }
    if (!never.empty()) {
        parts.push_back(fmt::format("{} {} stable at no step", fmt::join(never, " and "),
                                    never.size() == 1 ? "is" : "are"));
    }
    if (beyond > 0) {
        parts.push_back(fmt::format(
            "{} of {} methods without a limit stay finite at {:g} to {:g} times that of "
            "velocity-verlet",
            finite, beyond, factors_.front(), factors_.back()));
    }
    return fmt::format("{}", fmt::join(parts, ", and "));
}

std::string StabilityExperiment::answer() const {
    std::string limits = answer_of_limits(), rest = answer_of_the_rest();
    if (!limits.empty() && !rest.empty()) limits += "; ";
    std::string text = limits + rest;
    if (text.empty())
        text = "The methods asked for choose their steps themselves and have no limit";
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text + ".";
}

void StabilityExperiment::add_findings(Section& section) const {
    section.findings.push_back({"largest frequency omega_max", cloth_.omega(), "rad/s"});
    for (const Plan& plan : plans_) {
        if (!plan.has_limit()) continue;
        const std::string name(plan.info->name);
        section.findings.push_back({"predicted limit of " + name, plan.predicted, "s"});
        if (const std::optional<double> limit = observed(plan)) {
            section.findings.push_back({"observed limit of " + name, *limit, "s"});
        }
    }
}

}  // namespace

Section measure_stability(Laboratory& laboratory) {
    return StabilityExperiment(laboratory).run();
}

}  // namespace weft::lab
