#include "lab/energy/energy_figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace weft::lab {

namespace {

double change(const EnergyRun& run, const EnergySample& sample, double motion) {
    return (sample.account() - run.samples.front().account()) / motion;
}

}  // namespace

Plot energy_by_kind_plot(const EnergyCurve& curve, double time_step) {
    Series kinetic{"motion", {}, Series::Style::line, {}},
        gravity{"gravity", {}, Series::Style::line, {}},
        springs{"springs", {}, Series::Style::line, {}},
        total{"sum", {}, Series::Style::dashed, "neutral"};
    const std::vector<EnergySample>& samples = curve.run->samples;
    for (const EnergySample& sample : samples) {
        const double height = sample.gravity - samples.front().gravity;
        kinetic.points.push_back({sample.time, sample.kinetic});
        gravity.points.push_back({sample.time, height});
        springs.points.push_back({sample.time, sample.springs});
        total.points.push_back({sample.time, sample.kinetic + height + sample.springs});
    }
    const EnergySample& last = samples.back();
    Plot plot{fmt::format("kinds-{}", curve.method),
              fmt::format("Energy by kind: {} at {:.3g} s", curve.method, time_step),
              "time [s]",
              "energy [J]",
              false,
              false,
              false,
              {std::move(kinetic), std::move(gravity), std::move(springs), std::move(total)},
              {},
              {}};
    plot.text = fmt::format(
        "After {:.3g} s the motion has {:.3g} J, the springs {:.3g} J, gravity {:.3g} J since the "
        "start; the sum has changed by {:.3g} J, the work done on the cloth is {:.3g} J.",
        last.time, last.kinetic, last.springs, last.gravity - samples.front().gravity,
        last.total() - samples.front().total(), last.work);
    return plot;
}

Plot account_plot(const std::string& id, const std::string& title,
                  const std::vector<EnergyCurve>& curves, double motion, double most) {
    Plot plot{id, title, "time [s]", "change of E - W / energy of the motion", false, false, false,
              {}, {},    {}};
    std::vector<std::string> ends;
    for (const EnergyCurve& curve : curves) {
        Series series{
            std::string(curve.method), {}, Series::Style::line, std::string(curve.method)};
        double last = 0.0;
        for (const EnergySample& sample : curve.run->samples) {
            last = change(*curve.run, sample, motion);
            if (!(std::abs(last) <= most)) break;
            series.points.push_back({sample.time, last});
        }
        ends.push_back(std::abs(last) <= most ? fmt::format("{} {:+.2g}", curve.method, last)
                                              : fmt::format("{} beyond {:g}", curve.method, most));
        plot.series.push_back(std::move(series));
    }
    plot.text = fmt::format("At the end: {}. Curves that change by more than {:g} end there.",
                            fmt::join(ends, ", "), most);
    return plot;
}

Plot largest_change_plot(const std::vector<EnergyCurve>& curves, double motion) {
    Plot plot{"largest-change",
              "The largest change of energy so far",
              "time [s]",
              "largest change of E - W so far / energy of the motion",
              true,
              true,
              false,
              {},
              {},
              {}};
    std::vector<std::string> ends;
    for (const EnergyCurve& curve : curves) {
        Series series{
            std::string(curve.method), {}, Series::Style::line, std::string(curve.method)};
        double largest = 0.0;
        for (const EnergySample& sample : curve.run->samples) {
            largest = std::max(largest, std::abs(change(*curve.run, sample, motion)));
            if (largest > 0.0) series.points.push_back({sample.time, largest});
            if (largest > 10.0) break;
        }
        ends.push_back(fmt::format("{} {:.2g}", curve.method, largest));
        plot.series.push_back(std::move(series));
    }
    plot.text = fmt::format(
        "A curve that levels off is an error that stays bounded, one that keeps rising a drift. At "
        "the end, or where it passes 10: {}.",
        fmt::join(ends, ", "));
    return plot;
}

}  // namespace weft::lab
