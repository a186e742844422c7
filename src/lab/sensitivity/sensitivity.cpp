// The experiment "sensitivity": how fast two flights part that begin almost alike.
#include "lab/sensitivity/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/experiment.h"
#include "lab/flight_cost.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

constexpr double apart_part = 0.01;  // of the cloth's diagonal: apart
constexpr double step_part = 0.2;    // of the method's limit
constexpr double longest = 4.0;      // flight, in durations of the scene
constexpr double fit_to = 1e-2;      // of a cell, where the fit of the rate ends

// Two flights by a method.
struct Pair {
    std::string_view method;
    double nudge = 0.0;  // of a cell
    PartingPlan plan;
    Parting parting;
};

Trial parting_trial(const SceneDescription& scene, const PartingPlan& plan, double cost) {
    const auto measure = [scene, plan](const Watch& watch) {
        const Parting parting = part(scene, plan, watch);
        return nlohmann::json{{"points", parting.points}, {"failure", parting.failure}};
    };
    return {fmt::format("{} dt={:.8g} steps={} nudge={:.6g} to={:.6g}", plan.method, plan.time_step,
                        plan.steps, plan.nudge, plan.enough),
            measure, cost};
}

class SensitivityExperiment {
public:
    explicit SensitivityExperiment(Laboratory& laboratory) : laboratory_(laboratory) {}

    Section run();

private:
    void plan(Specimen& specimen);
    void add(Specimen& specimen, std::string_view method, double nudge);
    void gather();
    [[nodiscard]] double apart() const { return apart_part * diagonal_; }
    // From ten times where it began to a hundredth of a cell.
    [[nodiscard]] std::optional<PartingRate> rate_of(const Pair& pair) const {
        if (pair.parting.points.empty()) return std::nullopt;
        return parting_rate(pair.parting, 10.0 * pair.parting.points.front()[1], fit_to * cell_);
    }
    [[nodiscard]] Plot plot() const;
    [[nodiscard]] Table table() const;
    [[nodiscard]] std::vector<Cell> row(const Pair& pair) const;
    [[nodiscard]] std::string proportion_text() const;
    [[nodiscard]] std::string method_text() const;
    [[nodiscard]] std::string answer() const;
    [[nodiscard]] const Pair* find(std::string_view method, double nudge) const;

    Laboratory& laboratory_;
    double cell_ = 0.0, diagonal_ = 0.0;  // [m]
    std::vector<Pair> pairs_;
    std::vector<Trial> trials_;
};

void SensitivityExperiment::add(Specimen& specimen, std::string_view method, double nudge) {
    const SceneDescription& scene = laboratory_.scene();
    const bool quick = laboratory_.quick();
    Pair pair{method, nudge, {}, {}};
    pair.plan.method = method;
    pair.plan.time_step = step_part * specimen.modes().stable_step(method);
    pair.plan.nudge = nudge * cell_;
    pair.plan.enough = 1.2 * std::max(apart(), cell_);
    const double cost = 2.0 * find_integrator(method)->evaluations *
                        static_cast<double>(specimen.particle_count()) * evaluation_cost(scene);
    const double wanted = longest * scene.output.duration / pair.plan.time_step;
    const double most = std::max((quick ? 3e8 : 2e9) / cost, 200.0);
    pair.plan.steps = static_cast<std::size_t>(std::ceil(std::min(wanted, most)));
    trials_.push_back(parting_trial(scene, pair.plan, cost * static_cast<double>(pair.plan.steps)));
    pairs_.push_back(std::move(pair));
}

void SensitivityExperiment::plan(Specimen& specimen) {
    cell_ = cell_size(specimen.cloth());
    diagonal_ = specimen.cloth().rest_diagonal();
    for (const double nudge : {1e-12, 1e-9, 1e-6}) add(specimen, "velocity-verlet", nudge);
    add(specimen, "rk4", 1e-12);
    if (laboratory_.quick()) return;
    add(specimen, "rk4", 1e-9);
    add(specimen, "rk4", 1e-6);
}

void SensitivityExperiment::gather() {
    const std::vector<nlohmann::json> results = laboratory_.run(trials_);
    for (std::size_t n = 0; n < pairs_.size(); ++n) {
        Parting& parting = pairs_[n].parting;
        parting.points = results[n].at("points").get<std::vector<std::array<double, 2>>>();
        parting.failure = results[n].at("failure").get<std::string>();
    }
}

const Pair* SensitivityExperiment::find(std::string_view method, double nudge) const {
    const auto found = std::ranges::find_if(
        pairs_, [&](const Pair& pair) { return pair.method == method && pair.nudge == nudge; });
    return found == pairs_.end() ? nullptr : &*found;
}

Plot SensitivityExperiment::plot() const {
    Plot plot{"parting",  "Two flights that begin almost alike",
              "time [s]", "rms distance of the particles / cell",
              false,      true,
              false,      {},
              {},         {}};
    double end = 0.0;
    for (const Pair& pair : pairs_) {
        Series series{fmt::format("{}, from {:g} of a cell", pair.method, pair.nudge),
                      {},
                      Series::Style::line,
                      std::string(pair.method)};
        for (const auto& [time, distance] : pair.parting.points) {
            series.points.push_back({time, distance / cell_});
            end = std::max(end, time);
        }
        plot.series.push_back(std::move(series));
    }
    plot.series.push_back({"1 % of the cloth's size",
                           {{0.0, apart() / cell_}, {end, apart() / cell_}},
                           Series::Style::dashed,
                           "neutral"});
    const Pair& first = pairs_.front();
    const auto& last = first.parting.points.back();
    plot.text = fmt::format(
        "The distance from {:.2g} to {:.2g} of a cell in {:.3g} s, where two flights of {} began "
        "{:g} "
        "of "
        "a cell apart in one particle. {}",
        first.parting.points.front()[1] / cell_, last[1] / cell_, last[0], first.method,
        first.nudge, proportion_text());
    return plot;
}

// Whether the growth is a rate: nudges a million times larger should stay that much farther apart.
std::string SensitivityExperiment::proportion_text() const {
    const Pair *small = find("velocity-verlet", 1e-12), *large = find("velocity-verlet", 1e-6);
    if (small == nullptr || large == nullptr) return {};
    const auto &a = small->parting.points, &b = large->parting.points;
    double least = std::numeric_limits<double>::infinity(), most = 0.0, until = 0.0;
    for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n) {
        if (b[n][1] > 1e-3 * cell_) break;
        if (!(a[n][1] > 0.0)) continue;
        least = std::min(least, b[n][1] / a[n][1]);
        most = std::max(most, b[n][1] / a[n][1]);
        until = b[n][0];
    }
    if (!(most > 0.0)) return {};
    return fmt::format(
        "A nudge a million times larger stays {:.2g} to {:.2g} times farther apart up "
        "to {:.3g} s.",
        least, most, until);
}

std::vector<Cell> SensitivityExperiment::row(const Pair& pair) const {
    const std::optional<PartingRate> rate = rate_of(pair);
    const std::optional<double> a_cell = pair.parting.reaches(cell_),
                                apart_at = pair.parting.reaches(apart());
    const auto cell = [](const std::optional<double>& x) { return x ? Cell(*x) : Cell(); };
    std::string note = pair.parting.failure;
    if (note.empty() && !apart_at) note = "not apart by the end";
    if (!rate) note += note.empty() ? "no lasting growth" : "; no lasting growth";
    const auto& points = pair.parting.points;
    return {std::string(pair.method),
            pair.plan.time_step,
            pair.nudge,
            rate ? Cell(rate->rate) : Cell(),
            rate ? Cell(rate->from) : Cell(),
            rate ? Cell(rate->to) : Cell(),
            cell(apart_at),
            cell(a_cell),
            points.empty() ? Cell() : Cell(points.back()[0]),
            points.empty() ? Cell() : Cell(points.back()[1] / cell_),
            note.empty() ? Cell() : Cell(note)};
}

Table SensitivityExperiment::table() const {
    Table table{"parting-times",
                fmt::format("A row is a pair of flights. A cell is {:.4g} m, 1 % of the cloth's "
                            "size {:.4g} m.",
                            cell_, apart()),
                {{"Method"},
                 {"dt [s]"},
                 {"Nudge of one particle [cells]"},
                 {"Growth rate [1/s]", 3},
                 {"fitted from [s]", 3},
                 {"to [s]", 3},
                 {"1 % of the size apart after [s]", 3},
                 {"A cell apart after [s]", 3},
                 {"Flown [s]", 3},
                 {"Apart at the end [cells]", 3},
                 {"Note"}},
                {}};
    for (const Pair& pair : pairs_) table.rows.push_back(row(pair));
    return table;
}

std::string SensitivityExperiment::method_text() const {
    return fmt::format(
        "The scene is flown twice, in double precision and with {:g} of the method's stable step; "
        "in the second flight one particle in the middle begins a tiny part of a cell (mean length "
        "of the structural springs) away. The distance is the root mean square over all particles. "
        "The rate is fitted to its logarithm from where it has grown tenfold to a hundredth of a "
        "cell. Where velocity-verlet and rk4 agree, and small nudges grow as large ones do, the "
        "growth is the cloth's and no method's. The flights last {:g} times the scene's duration "
        "at most and end soon after the two are both a cell and 1 % of the cloth's size, its "
        "diagonal, apart.",
        step_part, longest);
}

std::string SensitivityExperiment::answer() const {
    const Pair &pair = pairs_.front(), &other = *find("rk4", 1e-12);
    const std::optional<double> time = pair.parting.reaches(apart()),
                                other_time = other.parting.reaches(apart());
    const std::optional<PartingRate> rate = rate_of(pair);
    const auto& last = pair.parting.points.back();
    if (!time) {
        return fmt::format(
            "Two flights that begin {:g} of a cell apart in one particle are {:.2g} of a cell "
            "apart "
            "after {:.3g} s{}: up to then a comparison particle by particle means something.",
            pair.nudge, last[1] / cell_, last[0],
            rate ? fmt::format(", growing by a factor e every {:.2g} s", 1.0 / rate->rate) : "");
    }
    const double e_fold = rate ? 1.0 / rate->rate : 0.0;
    return fmt::format(
        "Two flights of velocity-verlet that begin {:g} of a cell apart in one particle are 1 % of "
        "the cloth's size apart after {:.3g} s{}{}: from then on a comparison particle by particle "
        "means nothing.",
        pair.nudge, *time, other_time ? fmt::format(" (of rk4 after {:.3g} s)", *other_time) : "",
        rate ? fmt::format(", growing by a factor e every {:.2g} s on the way", e_fold) : "");
}

Section SensitivityExperiment::run() {
    Section section;
    Specimen specimen(laboratory_.scene());
    if (!(specimen.modes().modes.front().omega > 0.0)) {
        section.skipped =
            "No spring of this cloth holds a particle that may move: every particle "
            "flies on its own, and a nudge stays what it is.";
        return section;
    }
    plan(specimen);
    gather();
    const auto is_empty = [](const Pair& pair) { return pair.parting.points.empty(); };
    if (std::ranges::any_of(pairs_, is_empty)) {
        section.skipped = "The scene's state is not finite at its start.";
        return section;
    }
    section.method = method_text();
    section.blocks.emplace_back(plot());
    section.blocks.emplace_back(table());
    section.blocks.emplace_back(Paragraph{proportion_text()});
    section.answer = answer();
    for (const Pair& pair : pairs_) {
        if (const std::optional<PartingRate> rate = rate_of(pair); rate && pair.nudge == 1e-12) {
            section.findings.push_back(
                {fmt::format("rate of parting by {}", pair.method), rate->rate, "1/s"});
        }
    }
    if (const std::optional<double> time = pairs_.front().parting.reaches(apart())) {
        section.findings.push_back(
            {"time to part by 1 % of the size from 1e-12 of a cell", *time, "s"});
    }
    return section;
}

}  // namespace

Section measure_sensitivity(Laboratory& laboratory) {
    return SensitivityExperiment(laboratory).run();
}

}  // namespace weft::lab
