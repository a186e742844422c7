// Mass, dashpots and step, one at a time: how long each method lasts on the comparison's sheet.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "lab/settle/settle_parts.h"

namespace weft::lab {

namespace {

constexpr const char* new_velocity = "euler v+ moves x";

// A method looks the same in every plot; the slip is the catalogue's symplectic Euler.
std::string look_of(const std::string& update) {
    return update == new_velocity ? "symplectic-euler" : update;
}

// Every second value, the first and the last among them, where there is little time.
std::vector<double> thinned(const std::vector<double>& values, bool quick) {
    if (!quick) return values;
    std::vector<double> some;
    for (std::size_t n = 0; n < values.size(); n += 2) some.push_back(values[n]);
    return some;
}

}  // namespace

template <typename SheetOf>
SettleSweeps::Sweep SettleSweeps::sweep(RestBatch& batch, std::vector<std::string> updates,
                                        std::vector<double> values,
                                        const SheetOf& sheet_and_step) const {
    Sweep sweep{std::move(updates), std::move(values), {}};
    for (const double value : sweep.values) {
        const auto [sheet, step] = sheet_and_step(value);
        std::vector<std::size_t>& places = sweep.places.emplace_back();
        for (const std::string& update : sweep.updates) {
            places.push_back(add_seed_run(batch, sheet, update, step, duration_));
        }
    }
    return sweep;
}

SettleSweeps::SettleSweeps(RestBatch& batch, bool quick) : duration_(settle_duration(quick)) {
    const std::vector<std::string> three{"verlet", "forward-euler", "rk3"};
    masses_ = sweep(batch, three, thinned({0.03, 0.06, 0.12, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0}, quick),
                    [](double mass) {
                        return std::pair(SeedSheet{mass, 0.0, 0.0}, seed_time_step);
                    });
    dashpots_ =
        sweep(batch, three, thinned({0.0625, 0.125, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0}, quick),
              [](double ratio) {
                  return std::pair(SeedSheet{1.0, 0.0, ratio * seed_time_step}, seed_time_step);
              });
    std::vector<double> steps;
    for (int ms = 8; ms <= 24; ++ms) steps.push_back(1e-3 * ms);
    steps_ = sweep(batch, {"verlet", new_velocity, "forward-euler", "rk3"}, thinned(steps, quick),
                   [](double step) {
                       return std::pair(SeedSheet{1.0, 0.0, 0.0}, step);
                   });
}

Plot SettleSweeps::plot(const RestBatch& batch, const Sweep& sweep) const {
    Plot plot;
    plot.log_y = true;
    plot.y_label = "time until wrecked [s]";
    for (std::size_t u = 0; u < sweep.updates.size(); ++u) {
        const std::string& update = sweep.updates[u];
        Series series{update, {}, Series::Style::line_and_marks, look_of(update)};
        plot.text += fmt::format("{}{}:", u == 0 ? "" : ". ", update);
        for (std::size_t n = 0; n < sweep.values.size(); ++n) {
            const std::optional<double> time = batch[sweep.places[n][u]].wrecked();
            series.points.push_back({sweep.values[n], time.value_or(duration_)});
            plot.text += fmt::format("{} {:g}: {}", n == 0 ? "" : ",", sweep.values[n],
                                     time_text(time, duration_));
        }
        plot.series.push_back(std::move(series));
    }
    plot.text += ".";
    plot.series.push_back({"end of the run",
                           {{sweep.values.front(), duration_}, {sweep.values.back(), duration_}},
                           Series::Style::dashed,
                           "neutral"});
    return plot;
}

void SettleSweeps::tell(const RestBatch& batch, Section& section) const {
    const std::string step = fmt::format("{:g} ms", 1e3 * seed_time_step);
    Plot dashpots = plot(batch, dashpots_);
    dashpots.id = "dashpots";
    dashpots.title = "Dashpots: how long the sheet lasts, 1 kg a particle, " + step;
    dashpots.x_label = "c / (k dt) of every spring [1]";
    Plot masses = plot(batch, masses_);
    masses.id = "mass";
    masses.title = "Mass: how long the undamped sheet lasts, " + step;
    masses.x_label = "mass of a particle [kg]";
    masses.log_x = true;
    Plot steps = plot(batch, steps_);
    steps.id = "step";
    steps.title = "Step: how long the undamped sheet lasts, 1 kg a particle";
    steps.x_label = "dt [s]";
    section.blocks.emplace_back(std::move(dashpots));
    section.blocks.emplace_back(std::move(masses));
    section.blocks.emplace_back(std::move(steps));
}

std::string SettleSweeps::sentence(const RestBatch& batch) const {
    const auto in_order = [&](const Sweep& sweep) {
        std::vector<std::size_t> found;
        for (std::size_t n = 0; n < sweep.values.size(); ++n) {
            const std::vector<std::size_t>& places = sweep.places[n];
            if (in_printed_order(batch[places[0]], batch[places[1]], batch[places[2]])) {
                found.push_back(n);
            }
        }
        return found;
    };
    const std::vector<std::size_t> dashpots = in_order(dashpots_), masses = in_order(masses_);
    std::string text = "the printed order (Verlet, Forward Euler, R-K) comes of no dashpots tried";
    if (!dashpots.empty()) {
        text = fmt::format(
            "the printed order (Verlet, Forward Euler, R-K) comes of dashpots of {:g} "
            "to {:g} k dt",
            dashpots_.values[dashpots.front()], dashpots_.values[dashpots.back()]);
    }
    for (const std::size_t n : masses) {
        text += fmt::format(" and of a mass of {:g} kg (R-K wrecked: {})", masses_.values[n],
                            time_text(batch[masses_.places[n][2]].wrecked(), duration_));
    }
    return text;
}

SettleSweeps::Race SettleSweeps::race(const RestBatch& batch) const {
    Race race;
    for (const std::vector<std::size_t>& places : steps_.places) {
        const std::optional<double> verlet = batch[places[0]].wrecked();
        const std::optional<double> euler = batch[places[1]].wrecked();
        if (!verlet || !euler) continue;
        ++race.both;
        if (*verlet < *euler) ++race.verlet_first;
    }
    return race;
}

}  // namespace weft::lab
