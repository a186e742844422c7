#include "lab/energy/energy_leg.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::lab {

std::string name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::keeps:
            return "keeps it";
        case Verdict::loses:
            return "loses";
        case Verdict::gains:
            return "gains";
        case Verdict::too_short:
            break;
    }
    return "cannot be told";
}

std::string name_of(Stage stage) {
    switch (stage) {
        case Stage::quarter:
            return "1/4 of the limit";
        case Stage::half:
            return "1/2 of the limit";
        case Stage::automatic:
            return "automatic";
        case Stage::scene:
            break;
    }
    return "the scene as it is";
}

double smallest_limit(const StabilityModes& modes) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const IntegratorInfo& info : integrator_catalogue()) {
        if (info.imaginary_limit > 0.0) smallest = std::min(smallest, modes.stable_step(info.name));
    }
    return smallest;
}

EnergyTrend EnergyLeg::trend(const EnergyScale& scale) const {
    const double bound = blew_up(scale) ? scale.motion : std::numeric_limits<double>::infinity();
    const EnergyTrend late = energy_trend(run, 0.5 * flown(), bound);
    return late.to > late.from ? late : energy_trend(run, 0.0, bound);
}

double EnergyLeg::drift(const EnergyScale& scale) const {
    return trend(scale).slope * scale.period / scale.motion;
}

Verdict EnergyLeg::verdict(const EnergyScale& scale) const {
    constexpr double kept = 1e-5;           // of the motion's energy a period
    constexpr double least_periods = 10.0;  // before a drift is told from a swing
    const double change = last_change() / scale.motion;
    if (blew_up(scale)) return change > 0.0 ? Verdict::gains : Verdict::too_short;
    if (change < -0.5) return Verdict::loses;
    if (flown() < least_periods * scale.period) return Verdict::too_short;
    const double moved = drift(scale);
    if (std::abs(moved) <= kept) return Verdict::keeps;
    if (!trend(scale).is_sure()) return Verdict::too_short;
    return moved > 0.0 ? Verdict::gains : Verdict::loses;
}

double EnergyLeg::last_change() const {
    const std::size_t count = run.samples.size(), first = count - (count + 9) / 10;
    double sum = 0.0;
    for (std::size_t n = first; n < count; ++n) sum += run.samples[n].account();
    return sum / static_cast<double>(count - first) - run.samples.front().account();
}

bool EnergyLeg::blew_up(const EnergyScale& scale) const {
    return !run.failure.empty() || last_change() > 10.0 * scale.motion;
}

double EnergyLeg::largest_change() const {
    double largest = 0.0;
    for (const EnergySample& sample : run.samples) {
        largest = std::max(largest, std::abs(sample.account() - run.samples.front().account()));
    }
    return largest;
}

}  // namespace weft::lab
