// How far apart flights are and how wrinkled, in plots and tables.
#include <fmt/format.h>

#include <cmath>

#include "lab/look/look_show.h"
#include "weft/integrators.h"

namespace weft::lab {

Table flight_table(const Flown& flown) {
    Table table;
    table.id = flown.set.id + "-flights";
    table.caption = fmt::format(
        "The flights of {}, a row each. Distance: of the particles from {}, root mean square, at "
        "{:.3g} s. Wrinkles: rms angle between neighbouring triangles then; the reference has "
        "{:.3g} degrees.",
        flown.set.name, flown.set.reference->title, flown.set.end(),
        flown.reference->wrinkles.back());
    table.columns = {
        {"flight"}, {"dt [s]"}, {"failed at [s]"}, {"distance [m]"}, {"wrinkles [degrees]", 3},
        {"note"}};
    for (std::size_t n = 0; n < flown.flights.size(); ++n) {
        const LookSpec& spec = flown.set.flights[n];
        const LookFlight& flight = flown.flights[n];
        const bool adaptive = find_integrator(spec.plan.method)->kind == IntegratorKind::adaptive;
        std::string note = spec.note;
        if (flight.failed) note += (note.empty() ? "" : "; ") + flight.failure;
        const double distance = flown.last_distance(n);
        table.rows.push_back({spec.title, adaptive ? Cell() : Cell(spec.plan.time_step()),
                              flight.failed ? Cell(*flight.failed) : Cell("none"),
                              std::isnan(distance) ? Cell() : Cell(distance),
                              flight.failed ? Cell() : Cell(flight.wrinkles.back()), note});
    }
    return table;
}

Plot distance_plot(const Flown& flown) {
    Plot plot;
    plot.id = flown.set.id + "-distance";
    plot.title = "Distance from the reference: " + flown.set.name;
    plot.x_label = "time [s]";
    plot.y_label = "rms distance of the particles [m]";
    plot.log_y = true;
    for (std::size_t n = 0; n < flown.flights.size(); ++n) {
        const LookSpec& spec = flown.set.flights[n];
        if (spec.look == "neutral" || !spec.compared) continue;
        Series series{spec.title, {}, Series::Style::line, spec.look};
        for (std::size_t s = 1; s < flown.set.frames.size(); ++s) {
            const double distance = flown.distance(n, s);
            if (!std::isnan(distance)) series.points.push_back({flown.set.time(s), distance});
        }
        if (!series.points.empty()) {
            plot.text += fmt::format("{} is {:.3g} m away at {:.3g} s. ", spec.title,
                                     series.points.back()[1], series.points.back()[0]);
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

Plot wrinkle_plot(const Flown& flown) {
    Plot plot;
    plot.id = flown.set.id + "-wrinkles";
    plot.title = "Wrinkles: " + flown.set.name;
    plot.x_label = "time [s]";
    plot.y_label = "rms angle between neighbouring triangles [degrees]";
    const auto add = [&](const std::string& title, const std::string& look,
                         const LookFlight& flight, Series::Style style) {
        Series series{title, {}, style, look};
        for (std::size_t s = 0; s < flight.wrinkles.size(); ++s) {
            series.points.push_back({flown.set.time(s), flight.wrinkles[s]});
        }
        plot.text += fmt::format("{} has {:.3g} degrees at {:.3g} s. ", title,
                                 series.points.back()[1], series.points.back()[0]);
        plot.series.push_back(std::move(series));
    };
    for (std::size_t n = 0; n < flown.flights.size(); ++n) {
        const LookSpec& spec = flown.set.flights[n];
        if (spec.look == "neutral") continue;
        add(spec.title, spec.look, flown.flights[n], Series::Style::line);
    }
    add("reference: " + flown.set.reference->title, "neutral", *flown.reference,
        Series::Style::dashed);
    return plot;
}

}  // namespace weft::lab
