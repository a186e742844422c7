// The experiment "work-precision": what a method costs for the error that it makes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lab/experiment.h"
#include "lab/work_precision/pareto.h"
#include "lab/work_precision/work_flights.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

constexpr std::array<double, 4> goals{0.1, 0.01, 1e-3, 1e-4};  // of the motion

std::string percent(double share) {
    return fmt::format("{:g} %", 100.0 * share);
}

struct MethodSeries {
    std::string_view method;
    WorkSeries series;
};

// All that was measured on one of the scenes.
struct Ranking {
    WorkScene scene;
    WorkStretch stretch;
    std::vector<MethodSeries> methods{};
    // Of the front: place in `methods`, and in its series; by rising cost.
    std::vector<std::array<std::size_t, 2>> front{};

    [[nodiscard]] bool applies() const { return stretch.failure.empty() && stretch.motion > 0.0; }
    [[nodiscard]] const WorkPoint& point(std::array<std::size_t, 2> at) const {
        return methods[at[0]].series.points[at[1]];
    }
    [[nodiscard]] bool on_front(std::size_t method, std::size_t point) const {
        return std::ranges::find(front, std::array{method, point}) != front.end();
    }
};

// The cheapest flight of a series within the goal.
std::optional<std::size_t> cheapest(const WorkSeries& series, double error) {
    std::optional<std::size_t> best;
    for (std::size_t n = 0; n < series.points.size(); ++n) {
        const WorkPoint& point = series.points[n];
        if (!(point.error <= error)) continue;
        if (!best || point.ms < series.points[*best].ms) best = n;
    }
    return best;
}

// The cheapest method within the goal.
std::optional<std::array<std::size_t, 2>> winner(const Ranking& ranking, double goal) {
    std::optional<std::array<std::size_t, 2>> best;
    for (std::size_t n = 0; n < ranking.methods.size(); ++n) {
        const auto found = cheapest(ranking.methods[n].series, goal * ranking.stretch.motion);
        if (!found) continue;
        const std::array place{n, *found};
        if (!best || ranking.point(place).ms < ranking.point(*best).ms) best = place;
    }
    return best;
}

void find_front(Ranking& ranking) {
    std::vector<CostAndError> points;
    std::vector<std::array<std::size_t, 2>> places;
    for (std::size_t n = 0; n < ranking.methods.size(); ++n) {
        const std::vector<WorkPoint>& own = ranking.methods[n].series.points;
        for (std::size_t m = 0; m < own.size(); ++m) {
            points.push_back({own[m].ms, own[m].error});
            places.push_back({n, m});
        }
    }
    for (const std::size_t n : pareto_front(points)) ranking.front.push_back(places[n]);
}

std::vector<Ranking> scenes_with_ends(Laboratory& laboratory) {
    std::vector<Ranking> rankings;
    for (WorkScene& scene : work_scenes(laboratory.scene())) {
        rankings.push_back({std::move(scene), {}});
    }
    std::vector<Trial> trials;
    for (const Ranking& ranking : rankings) {
        trials.push_back({"reference of the " + ranking.scene.key + " scene",
                          [&ranking, quick = laboratory.quick()](const Watch& watch) {
                              Specimen specimen(ranking.scene.scene);
                              return work_stretch_to_json(
                                  specimen.cloth(), find_work_stretch(specimen, quick, watch));
                          },
                          ranking.scene.key == "stiff" ? 5.0 : 1.0});
    }
    const std::vector<nlohmann::json> found = laboratory.run(trials);
    for (std::size_t n = 0; n < rankings.size(); ++n) {
        const ClothModel cloth = build_cloth(rankings[n].scene.scene);
        rankings[n].stretch = work_stretch_from_json(cloth, found[n]);
    }
    return rankings;
}

void measure_methods(Laboratory& laboratory, std::vector<Ranking>& rankings) {
    std::vector<Trial> trials;
    for (const Ranking& ranking : rankings) {
        if (!ranking.applies()) continue;
        for (const std::string_view method : laboratory.methods()) {
            trials.push_back(
                {fmt::format("{} on the {} scene", method, ranking.scene.key),
                 [&ranking, plan = WorkPlan{method, laboratory.quick()}](const Watch& watch) {
                     Specimen specimen(ranking.scene.scene);
                     return work_series_to_json(
                         measure_work(specimen, plan, ranking.stretch, watch));
                 }});
        }
    }
    const std::vector<nlohmann::json> found = laboratory.run(trials, Batch::timed);
    std::size_t next = 0;
    for (Ranking& ranking : rankings) {
        if (!ranking.applies()) continue;
        for (const std::string_view method : laboratory.methods()) {
            ranking.methods.push_back({method, work_series_from_json(found[next++])});
        }
        find_front(ranking);
    }
}

// Why a series did not come to the goal.
std::string shortfall(const MethodSeries& method, double motion) {
    double best = std::numeric_limits<double>::infinity(), failed = best;
    std::string failure;
    for (const WorkPoint& point : method.series.points) {
        best = std::min(best, point.error);
        if (point.ok()) continue;
        failed = std::min(failed, point.step);
        failure = point.failure;
    }
    const std::string end = method.series.bounded ? ", then the work allowed was spent" : "";
    if (std::isinf(best)) return failure + end;
    std::string text = fmt::format("came to {:.2g} %", 100.0 * best / motion) + end;
    if (!failure.empty()) text += fmt::format("; failed with {:.2g} s", failed);
    return text;
}

std::vector<Cell> summary_row(const Ranking& ranking, std::size_t n) {
    const MethodSeries& method = ranking.methods[n];
    std::vector<Cell> row{std::string(method.method)};
    bool reached_all = true;
    for (const double goal : goals) {
        const auto found = cheapest(method.series, goal * ranking.stretch.motion);
        reached_all = reached_all && found.has_value();
        row.push_back(found ? Cell{method.series.points[*found].ms}
                            : Cell{std::string("not reached")});
    }
    bool front = false;
    for (const auto& place : ranking.front) front = front || place[0] == n;
    row.emplace_back(std::string(front ? "yes" : "no"));
    std::string note = reached_all ? "" : shortfall(method, ranking.stretch.motion);
    row.emplace_back(std::move(note));
    return row;
}

Table summary_table(const Ranking& ranking) {
    Table table{
        "cheapest-" + ranking.scene.key,
        fmt::format("What it costs to come so near, {} scene: a row is a method, a column an "
                    "error in per cent of the motion of {:.3g} m.",
                    ranking.scene.key, ranking.stretch.motion),
        {{"method", 0}},
        {}};
    for (const double goal : goals) {
        table.columns.push_back({"to " + percent(goal) + " [ms, varies]", 3});
    }
    table.columns.push_back({"on the front [varies]", 0});
    table.columns.push_back({"note", 0});
    for (std::size_t n = 0; n < ranking.methods.size(); ++n) {
        table.rows.push_back(summary_row(ranking, n));
    }
    return table;
}

Table flights_table(const Ranking& ranking) {
    Table table{"flights-" + ranking.scene.key,
                fmt::format("All flights, {} scene: a row is a method at one step or tolerance.",
                            ranking.scene.key),
                {{"method", 0},
                 {"step [s]", 3},
                 {"tolerance [m]", 2},
                 {"steps", 6},
                 {"evaluations", 7},
                 {"iterations", 7},
                 {"linear iterations", 7},
                 {"error [m]", 3},
                 {"error of the motion [%]", 3},
                 {"time [ms, varies]", 3},
                 {"on the front [varies]", 0},
                 {"note", 0}},
                {}};
    for (std::size_t n = 0; n < ranking.methods.size(); ++n) {
        const std::vector<WorkPoint>& points = ranking.methods[n].series.points;
        for (std::size_t m = 0; m < points.size(); ++m) {
            const WorkPoint& p = points[m];
            table.rows.push_back(
                {std::string(ranking.methods[n].method), p.step,
                 p.tolerance > 0.0 ? Cell{p.tolerance} : Cell{}, static_cast<double>(p.steps),
                 static_cast<double>(p.evaluations), static_cast<double>(p.newton_iterations),
                 static_cast<double>(p.linear_iterations), p.ok() ? Cell{p.error} : Cell{},
                 p.ok() ? Cell{100.0 * p.error / ranking.stretch.motion} : Cell{}, p.ms,
                 std::string(ranking.on_front(n, m) ? "yes" : ""), p.failure});
        }
    }
    return table;
}

std::string front_text(const Ranking& ranking) {
    std::string text;
    for (const auto& place : ranking.front) {
        const WorkPoint& point = ranking.point(place);
        text += fmt::format("{}{} {:.2g} % in {:.2g} ms", text.empty() ? "" : ", ",
                            ranking.methods[place[0]].method,
                            100.0 * point.error / ranking.stretch.motion, point.ms);
    }
    return text;
}

Plot ranking_plot(const Ranking& ranking) {
    Plot plot;
    plot.id = "work-precision-" + ranking.scene.key;
    plot.title = fmt::format("Error against cost: {} scene", ranking.scene.key);
    plot.x_label =
        fmt::format("time for {:.3g} s of motion [ms, varies]", ranking.stretch.length());
    plot.y_label = "rms error at the end [% of the motion]";
    plot.log_x = plot.log_y = true;
    const double per_cent = 100.0 / ranking.stretch.motion;
    Series front;
    front.name = "not beaten";
    front.style = Series::Style::dashed;
    front.look = "neutral";
    for (const auto& place : ranking.front) {
        const WorkPoint& point = ranking.point(place);
        front.points.push_back({point.ms, per_cent * point.error});
    }
    for (const MethodSeries& method : ranking.methods) {
        Series line;
        line.name = line.look = std::string(method.method);
        for (const WorkPoint& point : method.series.points) {
            // An error beyond ten times the motion is no motion of this cloth.
            if (per_cent * point.error <= 1000.0) {
                line.points.push_back({point.ms, per_cent * point.error});
            }
        }
        plot.series.push_back(std::move(line));
    }
    plot.series.push_back(std::move(front));
    plot.text = fmt::format(
        "Error at the end in per cent of the motion against the time of the flight, both axes "
        "logarithmic, a line a method; the nearer to the lower left corner the better. Not beaten "
        "by any other, from the cheapest to the most exact: {}.",
        front_text(ranking));
    return plot;
}

std::string scene_text(const Ranking& ranking) {
    const WorkStretch& stretch = ranking.stretch;
    std::string text = ranking.scene.text;
    if (!stretch.failure.empty()) return text + " It could not be flown: " + stretch.failure + ".";
    if (stretch.motion == 0.0) return text + " Nothing moves in it.";
    text += fmt::format(
        " Flown from its start for {:.3g} s, {:.4g} times the stable step of "
        "{:.3g} s; the particles move by {:.3g} m (rms). ",
        stretch.length(), stretch.length() / stretch.limit, stretch.limit, stretch.motion);
    text += stretch.shortened()
                ? fmt::format(
                      "It could have been {:.3g} s, but by then a disturbance has grown more "
                      "than {:g} times, and pointwise errors mean little.",
                      stretch.wanted, most_growth)
                : fmt::format("In that time disturbances grow less than {:g} times.", most_growth);
    return text + fmt::format(" The reference is exact to {:.1g} m, {:.1g} % of the motion.",
                              stretch.reference_error,
                              100.0 * stretch.reference_error / stretch.motion);
}

void add_blocks(const Ranking& ranking, Section& section) {
    section.blocks.emplace_back(Paragraph{scene_text(ranking)});
    if (!ranking.applies()) return;
    section.blocks.emplace_back(ranking_plot(ranking));
    section.blocks.emplace_back(summary_table(ranking));
    section.blocks.emplace_back(flights_table(ranking));
}

// "velocity-verlet on the soft scene (0.21 ms), ..."
std::string winners(const std::vector<Ranking>& rankings, double goal) {
    std::string text;
    for (const Ranking& ranking : rankings) {
        if (!ranking.applies()) continue;
        const auto best = winner(ranking, goal);
        text += text.empty() ? "" : ", ";
        text +=
            best ? fmt::format("{} on the {} scene ({:.2g} ms)", ranking.methods[(*best)[0]].method,
                               ranking.scene.key, ranking.point(*best).ms)
                 : fmt::format("no method on the {} scene", ranking.scene.key);
    }
    return text;
}

void add_findings(const Ranking& ranking, Section& section) {
    for (const double goal : {0.01, 1e-3}) {
        const auto best = winner(ranking, goal);
        if (!best) continue;
        section.findings.push_back({fmt::format("least time to {} of the motion, {} scene",
                                                percent(goal), ranking.scene.key),
                                    ranking.point(*best).ms, "ms, varies"});
    }
}

}  // namespace

Section measure_work_precision(Laboratory& laboratory) {
    std::vector<Ranking> rankings = scenes_with_ends(laboratory);
    measure_methods(laboratory, rankings);
    Section section;
    if (std::ranges::none_of(rankings, &Ranking::applies)) {
        section.skipped =
            "on none of the three scenes made from this one could errors be measured: " +
            scene_text(rankings.front());
        return section;
    }
    section.method =
        "Three scenes are made from this one, and every method flies each from its start, on one "
        "thread in double, with steps that are halved again and again; adaptive methods with "
        "smaller and smaller tolerances. Nothing else is tuned: iterations are the defaults, and "
        "implicit systems are solved to a millionth of the cloth's diagonal at first, to an eighth "
        "of that with each halving, as local errors of second order fall. The error is the root "
        "mean square distance of the particles from the reference at the end, the cost the time "
        "of stepping alone, the shortest of up to five repetitions of short flights. Flights go on "
        "until the error is below 0.005 % of the motion, or the next would take more evaluations "
        "and iterations than a fixed bound. Times are of this machine and vary from run to run, "
        "and with them what is on the front; errors and counts do not.";
    for (const Ranking& ranking : rankings) add_blocks(ranking, section);
    section.answer = fmt::format("Cheapest to 1 % of the motion: {}; to 0.1 %: {}.",
                                 winners(rankings, 0.01), winners(rankings, 1e-3));
    for (const Ranking& ranking : rankings) {
        if (ranking.applies()) add_findings(ranking, section);
    }
    return section;
}

}  // namespace weft::lab
