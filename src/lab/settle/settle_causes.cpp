// Why the comparison's authors saw Verlet wrinkle and Forward Euler do better: what each misprint
// and each slip does.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/settle/seed_steppers.h"
#include "lab/settle/settle_parts.h"

namespace weft::lab {

namespace {

constexpr double exact_step = 0.001;  // of rk4, which stands for the exact motion [s]
constexpr double early = 3.0;         // the "stable time" printed of Verlet [s]
constexpr double late = 15.0;         // that printed of Runge-Kutta [s]
constexpr double much_more = 1.2;     // of wrinkles: a fifth more shows
constexpr double first_steps = 2.5 * seed_time_step;  // [s]

// None: never.
double or_never(const std::optional<double>& time) {
    return time.value_or(std::numeric_limits<double>::infinity());
}

std::string why_not(const RestRun& verlet, const RestRun& euler, const RestRun& kutta) {
    const double v = or_never(verlet.wrecked()), e = or_never(euler.wrecked());
    if (std::isinf(v)) return "no: Verlet is not wrecked";
    if (e <= v) return "no: Forward Euler is wrecked first";
    if (std::isinf(e)) return "no: Forward Euler is not wrecked";
    return or_never(kutta.wrecked()) <= e ? "no: R-K is wrecked before Forward Euler" : "no";
}

// Wrinkles at a time, or when last seen before; with the time.
RestSample last_seen(const RestRun& run, double time) {
    RestSample last;
    for (const RestSample& sample : run.samples) {
        if (sample.time <= time + 1e-9) last = sample;
    }
    return last;
}

Series wrinkle_series(const RestRun& run, std::string name, std::string look, double duration) {
    Series series{std::move(name), {}, Series::Style::line, std::move(look)};
    const double end = or_never(run.wrecked());
    for (const RestSample& sample : run.samples) {
        if (sample.time > std::min(end, duration) + 1e-9) break;
        series.points.push_back({sample.time, sample.wrinkles});
    }
    if (series.look == "neutral") series.style = Series::Style::dashed;
    return series;
}

}  // namespace

bool in_printed_order(const RestRun& verlet, const RestRun& euler, const RestRun& kutta) {
    const double v = or_never(verlet.wrecked()), e = or_never(euler.wrecked());
    return v < e && std::isfinite(e) && e < or_never(kutta.wrecked());
}

SettleCauses::SettleCauses(RestBatch& batch, bool quick) : duration_(settle_duration(quick)) {
    // Dashpots of c = k dt: as many as Forward Euler needs to be stable at dt.
    const std::array<SeedSheet, 3> sheets{
        {{1.0, 0.0, 0.0}, {1.0, moderate_drag, 0.0}, {1.0, 0.0, seed_time_step}}};
    for (const SeedSheet& sheet : sheets) {
        add(batch, sheet, "rk4", Role::exact, exact_step, duration_);
        add(batch, sheet, "verlet", Role::verlet, seed_time_step, duration_);
        add(batch, sheet, "forward-euler", Role::euler, seed_time_step, duration_);
        add(batch, sheet, "rk3", Role::kutta, seed_time_step, duration_);
        add_updates(batch, sheet, quick);
    }
}

void SettleCauses::add(RestBatch& batch, const SeedSheet& sheet, std::string_view update, Role role,
                       double time_step, double duration) {
    const std::size_t place = add_seed_run(batch, sheet, update, time_step, duration);
    runs_.push_back({sheet, std::string(update), role, place, duration});
}

void SettleCauses::add_updates(RestBatch& batch, const SeedSheet& sheet, bool quick) {
    const bool drag = sheet.drag_rate > 0.0, damped = drag || sheet.dashpot_time > 0.0;
    for (const SeedUpdate& update : seed_updates()) {
        // Without what they damp, these two are the update that stands in the catalogue.
        if (update.name == "verlet (1 - d)(x - x_prev)" && !drag) continue;
        if (update.name == "verlet damped by eq. 6" && !damped) continue;
        const bool slow = update.name == "rk3 K2 implicit";
        if (slow && quick && damped) continue;
        const Role role = update.name.starts_with("verlet")  ? Role::verlet
                          : update.name.starts_with("euler") ? Role::euler
                                                             : Role::kutta;
        const double duration = !slow ? duration_ : quick ? 4.0 : 16.0;
        add(batch, sheet, update.name, role, seed_time_step, duration);
    }
}

SettleCauses::Four SettleCauses::base(const RestBatch& batch, const SeedSheet& sheet) const {
    Four four{};
    for (const Run& run : runs_) {
        if (describe(run.sheet) != describe(sheet)) continue;
        const RestRun* const result = &batch[run.place];
        if (run.role == Role::exact) four.exact = result;
        if (run.update == "verlet") four.verlet = result;
        if (run.update == "forward-euler") four.euler = result;
        if (run.update == "rk3") four.kutta = result;
    }
    return four;
}

SettleCauses::Four SettleCauses::with(const RestBatch& batch, const Run& run) const {
    Four four = base(batch, run.sheet);
    const RestRun* const result = &batch[run.place];
    if (run.role == Role::verlet) four.verlet = result;
    if (run.role == Role::euler) four.euler = result;
    if (run.role == Role::kutta) four.kutta = result;
    return four;
}

std::string SettleCauses::verdict(const RestBatch& batch, const Run& run,
                                  SettleSweeps::Race race) const {
    const Four four = with(batch, run);
    if (!in_printed_order(*four.verlet, *four.euler, *four.kutta)) {
        return why_not(*four.verlet, *four.euler, *four.kutta);
    }
    if (or_never(four.verlet->wrecked()) <= first_steps) {
        return "in order, but wrecked at once: nothing to see";
    }
    if (run.role == Role::euler && run.update != "forward-euler" && run.sheet.dashpot_time == 0.0) {
        return fmt::format("by chance: over the steps tried Verlet is first in {} of {}",
                           race.verlet_first, race.both);
    }
    return "yes";
}

Table SettleCauses::causes(const RestBatch& batch, SettleSweeps::Race race) const {
    Table table;
    table.id = "causes";
    table.caption = fmt::format(
        "What each update does to the comparison's sheet at dt = {:g} ms, an update with a damping "
        "a row. Wrinkles: the rms angle between neighbouring triangles at {:g} s, or when last "
        "seen "
        "before it was wrecked; beside it that of the exact motion then. The last column says "
        "whether the row, with the other two methods as they should be, gives the order that the "
        "authors print: Verlet wrecked first, then Forward Euler, then R-K.",
        1e3 * seed_time_step, early);
    table.columns = {{"update"},
                     {"sheet"},
                     {"wrecked at [s]"},
                     {"at rest from [s]"},
                     {"wrinkles at 3 s [degrees]", 3},
                     {"exact then [degrees]", 3},
                     {"wrinkles at 15 s [degrees]", 3},
                     {"exact at 15 s [degrees]", 3},
                     {"the printed order?"}};
    for (const Run& run : runs_) {
        if (run.role == Role::exact) continue;
        const RestRun& result = batch[run.place];
        const Four four = with(batch, run);
        const RestSample seen = last_seen(result, std::min(early, or_never(result.wrecked())));
        const bool to_late = or_never(result.wrecked()) > late && run.duration >= late;
        table.rows.push_back({run.update, describe(run.sheet), time_cell(result.wrecked()),
                              time_cell(result.rest), seen.wrinkles,
                              four.exact->at(seen.time).wrinkles,
                              to_late ? Cell(result.at(late).wrinkles) : Cell(),
                              four.exact->at(late).wrinkles, verdict(batch, run, race)});
    }
    return table;
}

Plot SettleCauses::wrinkles(const RestBatch& batch) const {
    const SeedSheet sheet{1.0, 0.0, 0.0};
    const Four four = base(batch, sheet);
    Plot plot;
    plot.id = "wrinkles";
    plot.title = "Wrinkles of the undamped sheet";
    plot.x_label = "time [s]";
    plot.y_label = "rms angle between neighbouring triangles [degrees]";
    plot.series = {wrinkle_series(*four.exact, "exact motion", "neutral", duration_),
                   wrinkle_series(*four.euler, "forward-euler", "forward-euler", duration_),
                   wrinkle_series(*four.verlet, "verlet", "verlet", duration_),
                   wrinkle_series(*four.kutta, "rk3", "rk3", duration_)};
    plot.text = fmt::format(
        "At {0:g} s the exact motion has wrinkles of {1:.3g} degrees, verlet {2:.3g} and rk3 "
        "{3:.3g}. Forward Euler ends at {4:.3g} s with {5:.3g} degrees.",
        late, four.exact->at(late).wrinkles, four.verlet->at(late).wrinkles,
        four.kutta->at(late).wrinkles, or_never(four.euler->wrecked()),
        last_seen(*four.euler, or_never(four.euler->wrecked())).wrinkles);
    return plot;
}

void SettleCauses::tell(const RestBatch& batch, SettleSweeps::Race race, Section& section) const {
    section.blocks.emplace_back(wrinkles(batch));
    Table formulas;
    formulas.id = "updates";
    formulas.caption = "The updates beside the methods of the catalogue, one a row.";
    formulas.columns = {{"update"}, {"formula"}, {"from"}};
    for (const SeedUpdate& update : seed_updates()) {
        formulas.rows.push_back(
            {std::string(update.name), std::string(update.formula), std::string(update.source)});
    }
    section.blocks.emplace_back(std::move(formulas));
    section.blocks.emplace_back(causes(batch, race));
}

std::string SettleCauses::sentence(const RestBatch& batch, SettleSweeps::Race race) const {
    std::string found;
    for (const Run& run : runs_) {
        if (find_seed_update(run.update) == nullptr || run.sheet.dashpot_time > 0.0) continue;
        if (verdict(batch, run, race) != "yes") continue;
        found += (found.empty() ? "" : ", ") + run.update;
    }
    std::string text = found.empty() ? "no misprint or slip gives it without them but by chance"
                                     : "without them it comes of " + found;
    const Four plain = base(batch, {1.0, 0.0, 0.0});
    const double v = plain.verlet->at(late).wrinkles, k = plain.kutta->at(late).wrinkles;
    if (v > much_more * k) {
        text += fmt::format(
            "; Verlet's wrinkles are the undamped sheet's own (at {:g} s {:.3g} degrees, exact "
            "{:.3g}), and R-K smooths them ({:.3g}) as its step damps short waves",
            late, v, plain.exact->at(late).wrinkles, k);
    }
    return text;
}

}  // namespace weft::lab
