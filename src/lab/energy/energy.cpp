// The experiment "energy": which methods keep the energy of the motion in the long run.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "lab/energy/energy_answer.h"
#include "lab/energy/energy_figures.h"
#include "lab/energy/energy_leg.h"
#include "lab/experiment.h"
#include "lab/flight_cost.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

constexpr std::string_view reference = "velocity-verlet";  // whose motion is the measure
// Methods whose energy is drawn by kind.
constexpr std::array<std::string_view, 4> by_kind{"velocity-verlet", "rk4", "implicit-euler",
                                                  "xpbd"};

class EnergyExperiment {
public:
    explicit EnergyExperiment(Laboratory& laboratory)
        : laboratory_(laboratory), scene_(conservative_scene(laboratory.scene())) {}

    Section run();

private:
    std::string find_step();
    void plan();
    void add(const IntegratorInfo& info, Stage stage, bool asked);
    void add_all(const IntegratorInfo& info, bool asked);
    [[nodiscard]] double periods() const;
    // Whether implicit systems are solved so well that the drift is the method's own.
    [[nodiscard]] bool is_exact(Stage stage) const {
        return stage == Stage::quarter || stage == Stage::half ||
               (stage == Stage::automatic && laboratory_.quick());
    }
    [[nodiscard]] std::size_t affordable_steps(const EnergyLeg& leg) const;
    void gather();
    [[nodiscard]] double motion_in(Stage stage) const;
    [[nodiscard]] std::vector<EnergyCurve> curves(Stage stage, bool explicit_ones,
                                                  bool implicit_ones) const;
    void add_balance(Section& section) const;
    void add_plots(Section& section) const;
    [[nodiscard]] std::vector<const EnergyLeg*> legs_by_kind() const;
    [[nodiscard]] Table drift_table() const;
    [[nodiscard]] std::vector<Cell> drift_row(const EnergyLeg& leg) const;
    [[nodiscard]] const EnergyLeg* telling_leg(std::string_view method) const;
    [[nodiscard]] std::string method_text() const;
    [[nodiscard]] std::string answer() const;
    void add_findings(Section& section) const;

    Laboratory& laboratory_;
    SceneDescription scene_;  // conservative
    std::size_t particles_ = 1;
    double limit_ = 0.0;          // the smallest of an explicit method, undamped [s]
    double step_of_scene_ = 0.0;  // of explicit methods on the scene as it is [s]
    bool falls_ = false;          // gravity moves it without wind and pins
    EnergyScale scale_;           // of the conservative scene
    std::vector<EnergyLeg> legs_;
    std::vector<Trial> trials_;
};

// @return why the experiment does not apply, or nothing.
std::string EnergyExperiment::find_step() {
    Specimen specimen(scene_);
    const ClothModel& cloth = specimen.cloth();
    particles_ = cloth.particle_count;
    const double omega = specimen.modes().modes.front().omega;
    if (!(omega > 0.0)) {
        return "No spring of this cloth holds a particle that may move: there is no period to "
               "measure a drift by.";
    }
    falls_ = length(scene_.forces.gravity) > 0.0 && cloth.pins.size() < cloth.particle_count;
    const SceneDescription& given = laboratory_.scene();
    const bool moved = given.wind || std::ranges::any_of(given.pins, [](const auto& pin) {
                           return !pin.motion.empty();
                       });
    if (!falls_ && !moved)
        return "Nothing moves in this scene: no gravity, no wind, no moving pin.";
    scale_.period = 2.0 * std::numbers::pi / omega;
    limit_ = smallest_limit(specimen.modes());
    // Damping may shorten the limits.
    step_of_scene_ = std::min(0.25 * limit_, 0.5 * smallest_limit(Specimen(given).modes()));
    return {};
}

// Periods of the long run.
double EnergyExperiment::periods() const {
    return laboratory_.quick() ? 600.0 : 2000.0;
}

// Steps for a flight of `time`, but no more than time allows.
std::size_t EnergyExperiment::affordable_steps(const EnergyLeg& leg) const {
    constexpr double least = 40.0;
    const double worth = !laboratory_.quick() ? 8e8 : leg.is_explicit() ? 6e7 : 2e8;  // evaluations
    const SceneDescription& scene = leg.stage == Stage::scene ? laboratory_.scene() : scene_;
    double cost = step_cost(leg.info->name, is_exact(leg.stage)) * evaluation_cost(scene);
    if (!is_conservative(scene)) cost += power_cost(scene);
    const double most = worth / cost / static_cast<double>(particles_);
    const double steps = std::ceil(leg.wanted / leg.time_step);
    return static_cast<std::size_t>(std::max(std::min(steps, most), least));
}

void EnergyExperiment::add(const IntegratorInfo& info, Stage stage, bool asked) {
    EnergyLeg leg{&info, stage, 0.25 * limit_, 0, 0.0, asked, {}};
    if (stage == Stage::half) leg.time_step = 0.5 * limit_;
    if (stage == Stage::scene) leg.time_step = step_of_scene_;
    const bool long_run = stage == Stage::quarter || stage == Stage::half;
    if (!leg.is_explicit() && !long_run) leg.time_step = info.auto_step;
    leg.wanted = long_run ? periods() * scale_.period : laboratory_.scene().output.duration;
    leg.planned = affordable_steps(leg);
    const EnergyPlan plan{info.name, leg.time_step, leg.planned, 600, is_exact(stage)};
    trials_.push_back(stage == Stage::scene ? energy_trial(laboratory_.scene(), plan, "scene")
                                            : energy_trial(scene_, plan, "conservative scene"));
    legs_.push_back(std::move(leg));
}

void EnergyExperiment::add_all(const IntegratorInfo& info, bool asked) {
    const bool drawn = std::ranges::find(by_kind, info.name) != by_kind.end();
    if (!is_conservative(laboratory_.scene()) || drawn) add(info, Stage::scene, asked);
    if (!falls_) return;
    const bool is_explicit = info.kind == IntegratorKind::explicit_steps;
    const bool has_limit = is_explicit || info.kind == IntegratorKind::adaptive;
    if (has_limit || !laboratory_.quick()) add(info, Stage::quarter, asked);
    if (!has_limit) add(info, Stage::automatic, asked);
    if (is_explicit && asked && !laboratory_.quick()) add(info, Stage::half, asked);
}

void EnergyExperiment::plan() {
    bool has_reference = false;
    for (const std::string_view name : laboratory_.methods()) {
        add_all(*find_integrator(name), true);
        has_reference |= name == reference;
    }
    if (!has_reference) add_all(*find_integrator(reference), false);
}

void EnergyExperiment::gather() {
    const std::vector<nlohmann::json> results = laboratory_.run(trials_);
    for (std::size_t n = 0; n < legs_.size(); ++n) legs_[n].run = energy_run_from_json(results[n]);
    scale_.motion = motion_in(Stage::quarter);
}

// The most kinetic energy that the reference has.
double EnergyExperiment::motion_in(Stage stage) const {
    double most = 0.0;
    for (const EnergyLeg& leg : legs_) {
        if (leg.info->name != reference || leg.stage != stage) continue;
        for (const EnergySample& sample : leg.run.samples) most = std::max(most, sample.kinetic);
    }
    return most;
}

std::vector<EnergyCurve> EnergyExperiment::curves(Stage stage, bool explicit_ones,
                                                  bool implicit_ones) const {
    std::vector<EnergyCurve> found;
    for (const EnergyLeg& leg : legs_) {
        if (leg.stage != stage || !leg.asked) continue;
        if (leg.is_explicit() ? explicit_ones : implicit_ones) {
            found.push_back({leg.info->name, &leg.run});
        }
    }
    return found;
}

// E - W of the scene as it is.
void EnergyExperiment::add_balance(Section& section) const {
    const auto add = [&](const std::vector<EnergyCurve>& drawn, const auto& plot) {
        if (!drawn.empty()) section.blocks.emplace_back(plot(drawn));
    };
    const double motion = motion_in(Stage::scene);
    add(curves(Stage::scene, true, false), [&](const auto& drawn) {
        return account_plot("balance",
                            fmt::format("The scene as it is: energy less the work of dashpots, "
                                        "drag, air and pins, at {:.3g} s",
                                        step_of_scene_),
                            drawn, motion, 0.1);
    });
    add(curves(Stage::scene, false, true), [&](const auto& drawn) {
        Plot plot = account_plot("balance-automatic",
                                 "The same of methods without a limit, at their automatic steps",
                                 drawn, motion, 1.0);
        plot.text += " With steps so long the sum of the work is itself coarse.";
        return plot;
    });
}

void EnergyExperiment::add_plots(Section& section) const {
    const auto add = [&](const std::vector<EnergyCurve>& drawn, const auto& plot) {
        if (!drawn.empty()) section.blocks.emplace_back(plot(drawn));
    };
    if (falls_) {
        add(curves(Stage::quarter, true, false), [&](const auto& drawn) {
            return account_plot(
                "explicit",
                fmt::format("Energy in the long run: explicit methods at {:.3g} s", 0.25 * limit_),
                drawn, scale_.motion, 0.1);
        });
        add(curves(Stage::quarter, true, true),
            [&](const auto& drawn) { return largest_change_plot(drawn, scale_.motion); });
        add(curves(Stage::automatic, false, true), [&](const auto& drawn) {
            return account_plot("automatic", "Methods without a limit, at their automatic steps",
                                drawn, scale_.motion, 1.0);
        });
    }
    if (!is_conservative(laboratory_.scene())) add_balance(section);
    for (const EnergyLeg* leg : legs_by_kind()) {
        section.blocks.emplace_back(
            energy_by_kind_plot({leg->info->name, &leg->run}, leg->time_step));
    }
}

// Flights of the scene as it is that stand for the others; any where none of them was asked for.
std::vector<const EnergyLeg*> EnergyExperiment::legs_by_kind() const {
    std::vector<const EnergyLeg*> found;
    const EnergyLeg* any = nullptr;
    for (const EnergyLeg& leg : legs_) {
        if (leg.stage != Stage::scene) continue;
        if (any == nullptr) any = &leg;
        if (leg.asked && std::ranges::find(by_kind, leg.info->name) != by_kind.end()) {
            found.push_back(&leg);
        }
    }
    if (found.empty() && any != nullptr) found.push_back(any);
    return found;
}

std::vector<Cell> EnergyExperiment::drift_row(const EnergyLeg& leg) const {
    std::string note = leg.run.failure;
    const bool is_cut = static_cast<double>(leg.planned) * leg.time_step < 0.999 * leg.wanted;
    if (note.empty() && is_cut) note = "flight cut short: its steps cost more";
    return {std::string(leg.info->name),
            name_of(leg.stage),
            leg.time_step,
            leg.flown() / scale_.period,
            leg.drift(scale_),
            leg.trend(scale_).error * scale_.period / scale_.motion,
            leg.largest_change() / scale_.motion,
            name_of(leg.verdict(scale_)),
            note.empty() ? Cell() : Cell(note)};
}

Table EnergyExperiment::drift_table() const {
    Table table{"drift",
                fmt::format("A row is a flight of the scene without air, damping and moving pins. "
                            "The drift is the slope of a line through the energy, times the period "
                            "of the fastest mode ({:.4g} s), over the energy of the motion ({:.4g} "
                            "J).",
                            scale_.period, scale_.motion),
                {{"Method"},
                 {"Step"},
                 {"dt [s]"},
                 {"Flight [periods]"},
                 {"Drift a period", 3},
                 {"Standard error", 2},
                 {"Largest change / energy of the motion", 3},
                 {"Energy"},
                 {"Note"}},
                {}};
    for (const EnergyLeg& leg : legs_) {
        if (leg.stage != Stage::scene && leg.asked) table.rows.push_back(drift_row(leg));
    }
    return table;
}

// The flight that a method is judged by: at the common step, where it was long enough.
const EnergyLeg* EnergyExperiment::telling_leg(std::string_view method) const {
    const EnergyLeg* found = nullptr;
    for (const EnergyLeg& leg : legs_) {
        if (leg.info->name != method || !leg.asked) continue;
        if (leg.stage != Stage::quarter && leg.stage != Stage::automatic) continue;
        if (found == nullptr || found->verdict(scale_) == Verdict::too_short) found = &leg;
    }
    return found;
}

std::string EnergyExperiment::method_text() const {
    const bool quick = laboratory_.quick();
    std::string text = fmt::format(
        "Every method flies the scene in double precision. For the long run the scene is made "
        "conservative: no air, no drag, no dashpots, pins held still; then an exact solution keeps "
        "its energy E. The step is a quarter of the smallest limit that an explicit method has on "
        "it ({:.3g} s){}, for up to {:g} periods of the fastest mode; costly methods fly shorter. "
        "Methods without a limit are flown at their automatic steps{}. Implicit systems are solved "
        "to 1e-8 of the cloth's diagonal{}, so that the drift is the method's own. ",
        limit_, quick ? "" : ", and half of it for explicit methods", periods(),
        quick ? "" : " too", quick ? "" : " (at the automatic steps to 5e-5, as usual)");
    text += fmt::format(
        "The energy of the motion is the largest kinetic energy of {}. A line is fitted to the "
        "second half: in the first the cloth, smooth at the start, takes up shorter and shorter "
        "waves. Its standard error comes from the means of twelve stretches. A method keeps the "
        "energy where the drift is below 1 % of the motion's energy in 1000 periods; it gains or "
        "loses where it is more by three standard errors, where it blows up, or where half of that "
        "energy is gone at the end. Less than ten periods do not tell.",
        reference);
    if (!is_conservative(laboratory_.scene())) {
        text +=
            " The scene as it is loses energy to dashpots, drag and air, and gains it from wind "
            "and moving pins. Their work W is integrated by the trapezoidal rule at every step; "
            "E - W is what an exact solution keeps.";
    }
    return text;
}

std::string EnergyExperiment::answer() const {
    std::vector<const EnergyLeg*> judged;
    for (const std::string_view method : laboratory_.methods()) {
        if (const EnergyLeg* leg = telling_leg(method)) judged.push_back(leg);
    }
    return energy_answer(judged, scale_,
                         fmt::format("At a step of {:.3g} s{}", 0.25 * limit_,
                                     laboratory_.quick() ? " (methods without a limit at their "
                                                           "automatic steps)"
                                                         : ""));
}

void EnergyExperiment::add_findings(Section& section) const {
    for (const std::string_view method : laboratory_.methods()) {
        const EnergyLeg* leg = telling_leg(method);
        if (leg == nullptr || leg->blew_up(scale_) || leg->verdict(scale_) == Verdict::too_short) {
            continue;
        }
        section.findings.push_back(
            {fmt::format("energy drift a period of {}", method), leg->drift(scale_), ""});
    }
}

Section EnergyExperiment::run() {
    Section section;
    section.skipped = find_step();
    if (!section.skipped.empty()) return section;
    plan();
    gather();
    section.method = method_text();
    add_plots(section);
    if (!falls_) {
        section.answer =
            "Without wind and moving pins nothing moves in this scene, so there is no energy to "
            "keep; the figures show the scene as it is.";
        return section;
    }
    section.blocks.insert(section.blocks.begin(), drift_table());
    section.answer = answer();
    add_findings(section);
    return section;
}

}  // namespace

Section measure_energy(Laboratory& laboratory) {
    return EnergyExperiment(laboratory).run();
}

}  // namespace weft::lab
