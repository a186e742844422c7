// The comparison's table 2, measured.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "lab/settle/settle_parts.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

struct PrintedTime {
    std::string_view method;  // of the catalogue
    std::string_view name;    // in the comparison
    double time;              // [s]
};
constexpr std::array<PrintedTime, 3> printed_times{
    {{"forward-euler", "Forward Euler", 8.0}, {"verlet", "Verlet", 3.0}, {"rk3", "R-K", 15.0}}};

constexpr double small_step = 0.001;  // [s]
constexpr double nylon_mass = 0.03;   // 0.12 kg/m2, shared by the particles [kg]

SeedSheet sheet_of(double mass, bool damped) {
    return damped ? SeedSheet{mass, moderate_drag, moderate_dashpots} : SeedSheet{mass, 0.0, 0.0};
}

bool is_damped(const SeedSheet& sheet) {
    return sheet.drag_rate > 0.0;
}

std::string outcome(const RestRun& run, double duration) {
    if (!run.failure.empty()) return run.failure;
    if (run.blow_up) return "blown up";
    if (run.gain) return "energy out of nothing";
    return run.rest ? "at rest" : fmt::format("still moving after {:g} s", duration);
}

}  // namespace

std::size_t add_seed_run(RestBatch& batch, const SeedSheet& sheet, std::string_view method,
                         double time_step, double duration) {
    // A drag written into the update must not act twice.
    const bool scaled = method == "verlet (1 - d)(x - x_prev)";
    SeedSheet made = sheet;
    if (scaled) made.drag_rate = 0.0;
    RestPlan plan;
    plan.method = method;
    plan.drag_rate = sheet.drag_rate;
    plan.time_step = time_step;
    plan.duration = duration;
    plan.look_every = 0.1;
    plan.released = fall_energy(sheet);
    return batch.add("seed sheet " + describe(sheet), seed_scene(made), plan);
}

std::string time_text(const std::optional<double>& time, double duration) {
    return time ? fmt::format("{:.3g} s", *time) : fmt::format("not within {:g} s", duration);
}

Cell time_cell(const std::optional<double>& time) {
    return time ? Cell(*time) : Cell("none");
}

SeedTable::SeedTable(RestBatch& batch, const std::vector<std::string_view>& methods, bool quick)
    : duration_(settle_duration(quick)) {
    std::vector<std::string_view> chosen;
    for (const PrintedTime& printed : printed_times) chosen.push_back(printed.method);
    for (const std::string_view method : methods) {
        if (method == "velocity-verlet" || method == "rk4") chosen.push_back(method);
    }
    for (const double mass : {1.0, nylon_mass}) {
        if (quick && mass != 1.0) continue;
        for (const bool damped : {false, true}) {
            for (const double step : {seed_time_step, small_step}) {
                for (const std::string_view method : chosen) {
                    const SeedSheet sheet = sheet_of(mass, damped);
                    runs_.push_back(
                        {sheet, step, method, add_seed_run(batch, sheet, method, step, duration_)});
                }
            }
        }
    }
}

const RestRun& SeedTable::run_of(const RestBatch& batch, bool damped, double time_step,
                                 std::string_view method) const {
    std::size_t place = 0;
    for (const Run& run : runs_) {
        if (run.sheet.particle_mass == 1.0 && is_damped(run.sheet) == damped &&
            run.time_step == time_step && run.method == method) {
            place = run.place;
        }
    }
    return batch[place];
}

Table SeedTable::printed(const RestBatch& batch) const {
    Table table;
    table.id = "table-2";
    table.caption = fmt::format(
        "The comparison's table 2 and ours, a method a row. Ours with 1 kg a particle; {:g} ms is "
        "the step that its table 1 implies. Wrecked: blown up, or energy out of nothing. None: not "
        "within {:g} s.",
        1e3 * seed_time_step, duration_);
    table.columns = {{"method"}, {"printed \"stable time\" [s]"}};
    for (const char* damping : {"undamped", "damped"}) {
        for (const double step : {seed_time_step, small_step}) {
            for (const char* what : {"wrecked", "at rest"}) {
                table.columns.push_back(
                    {fmt::format("{}, {:g} ms: {} [s]", damping, 1e3 * step, what)});
            }
        }
    }
    for (const PrintedTime& printed : printed_times) {
        std::vector<Cell> row{std::string(printed.name), printed.time};
        for (const bool damped : {false, true}) {
            for (const double step : {seed_time_step, small_step}) {
                const RestRun& run = run_of(batch, damped, step, printed.method);
                row.push_back(time_cell(run.wrecked()));
                row.push_back(time_cell(run.rest));
            }
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table SeedTable::all(const RestBatch& batch) const {
    Table table;
    table.id = "runs";
    table.caption = fmt::format(
        "Every run on the comparison's sheet, a row each, {:g} s long. Damped: drag of {:g} /s and "
        "dashpots of c = {:g} ms k. The limit is the longest stable step that theory gives the "
        "method on this sheet at rest; 0: none.",
        duration_, moderate_drag, 1e3 * moderate_dashpots);
    table.columns = {{"particle mass [kg]"},
                     {"damped"},
                     {"dt [s]"},
                     {"method"},
                     {"limit of dt [s]"},
                     {"at rest from [s]"},
                     {"energy out of nothing [s]"},
                     {"blown up [s]"},
                     {"in the end"}};
    std::optional<Specimen> specimen;
    std::string described;
    for (const Run& run : runs_) {
        if (describe(run.sheet) != described) {
            described = describe(run.sheet);
            specimen.emplace(seed_scene(run.sheet));
        }
        const RestRun& result = batch[run.place];
        table.rows.push_back({run.sheet.particle_mass, is_damped(run.sheet) ? "yes" : "no",
                              run.time_step, std::string(run.method),
                              specimen->modes().stable_step(run.method), time_cell(result.rest),
                              time_cell(result.gain), time_cell(result.blow_up),
                              outcome(result, duration_)});
    }
    return table;
}

void SeedTable::tell(const RestBatch& batch, Section& section) const {
    section.blocks.emplace_back(printed(batch));
    section.blocks.emplace_back(all(batch));
    for (const PrintedTime& printed : printed_times) {
        const RestRun& run = run_of(batch, false, seed_time_step, printed.method);
        if (run.wrecked()) {
            section.findings.push_back(
                {fmt::format("time to wreck of {}, undamped", printed.method), *run.wrecked(),
                 "s"});
        }
    }
}

std::string SeedTable::sentence(const RestBatch& batch) const {
    std::string text = fmt::format("On the comparison's sheet (1 kg a particle, undamped, {:g} ms)",
                                   1e3 * seed_time_step);
    const char* between = " ";
    for (const PrintedTime& printed : printed_times) {
        const RestRun& run = run_of(batch, false, seed_time_step, printed.method);
        text += fmt::format("{}{} is {} (printed: {:g} s)", between, printed.name,
                            run.wrecked() ? fmt::format("wrecked after {:.3g} s", *run.wrecked())
                                          : fmt::format("not wrecked within {:g} s", duration_),
                            printed.time);
        between = ", ";
    }
    double first = std::numeric_limits<double>::infinity(), last = 0.0;
    for (const PrintedTime& printed : printed_times) {
        const RestRun& run = run_of(batch, true, seed_time_step, printed.method);
        if (!run.rest) continue;
        first = std::min(first, *run.rest);
        last = std::max(last, *run.rest);
    }
    if (last > 0.0) {
        const std::string from = fmt::format("{:.3g}", first), to = fmt::format("{:.3g}", last);
        text += fmt::format(
            "; with moderate damping what rests does so after {} s by every method, so the printed "
            "times are not times to rest",
            from == to ? from : from + " to " + to);
    }
    return text;
}

}  // namespace weft::lab
