#include "lab/energy/energy_answer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string_view>

namespace weft::lab {

namespace {

using Legs = std::vector<const EnergyLeg*>;

// A part of the motion's energy a period: by the trend, or where that ended because nothing was
// left to lose, by the whole flight.
double rate(const EnergyLeg& leg, const EnergyScale& scale) {
    const double whole = leg.last_change() * scale.period / leg.flown() / scale.motion;
    return std::max(std::abs(leg.drift(scale)), std::abs(whole));
}

Legs filtered(const Legs& legs, const std::function<bool(const EnergyLeg&)>& wanted) {
    Legs found;
    std::ranges::copy_if(legs, std::back_inserter(found),
                         [&](const EnergyLeg* leg) { return wanted(*leg); });
    return found;
}

// "rk3, rk4 lose energy"; nothing of no flights.
std::string told(const Legs& legs, std::string_view verb, std::string_view rest) {
    if (legs.empty()) return {};
    std::vector<std::string_view> names;
    for (const EnergyLeg* leg : legs) names.push_back(leg->info->name);
    return fmt::format("{} {}{} {}", fmt::join(names, ", "), verb, names.size() == 1 ? "s" : "",
                       rest);
}

// ", 8.1e-05 to 0.0026 of the motion's a period"
std::string rates(const Legs& legs, const EnergyScale& scale) {
    if (legs.empty()) return {};
    std::vector<double> values;
    for (const EnergyLeg* leg : legs) values.push_back(rate(*leg, scale));
    const auto [least, most] = std::ranges::minmax(values);
    return values.size() == 1
               ? fmt::format(", {:.2g} of the motion's a period", most)
               : fmt::format(", {:.2g} to {:.2g} of the motion's a period", least, most);
}

std::string periods_flown(const Legs& legs, const EnergyScale& scale) {
    std::vector<double> periods;
    for (const EnergyLeg* leg : legs) {
        if (!leg->blew_up(scale)) periods.push_back(leg->flown() / scale.period);
    }
    if (periods.empty()) return {};
    const auto [least, most] = std::ranges::minmax(periods);
    return fmt::format(" and over {:.3g} to {:.4g} periods of the fastest mode", least, most);
}

}  // namespace

std::string energy_answer(const Legs& legs, const EnergyScale& scale,
                          const std::string& beginning) {
    const auto with = [&](Verdict verdict) {
        return filtered(legs, [&](const EnergyLeg& leg) {
            return !leg.blew_up(scale) && leg.verdict(scale) == verdict;
        });
    };
    const auto ended = [&](bool gaining) {
        return filtered(legs, [&](const EnergyLeg& leg) {
            return leg.blew_up(scale) && (leg.verdict(scale) == Verdict::gains) == gaining;
        });
    };
    const Legs losing = with(Verdict::loses), gaining = with(Verdict::gains);
    std::vector<std::string> parts{
        told(with(Verdict::keeps), "keep", "the energy (within 1 % in 1000 periods)"),
        told(losing, "lose", "energy") + rates(losing, scale),
        told(gaining, "gain", "energy") + rates(gaining, scale),
        told(ended(true), "gain", "energy until the cloth blows up"),
        told(ended(false), "fail", "before the end of the flight"),
        told(with(Verdict::too_short), "show", "no clear trend")};
    std::erase(parts, std::string());
    return fmt::format("{}{}: {}.", beginning, periods_flown(legs, scale), fmt::join(parts, "; "));
}

}  // namespace weft::lab
