// The figures of the experiment "energy".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lab/energy/energy_run.h"
#include "lab/section.h"

namespace weft::lab {

/// A flight and how it is drawn.
struct EnergyCurve {
    std::string_view method;
    const EnergyRun* run = nullptr;
};

/// Kinetic energy, that of gravity and of springs, and their sum, against time; gravity from 0 at
/// the start.
Plot energy_by_kind_plot(const EnergyCurve& curve, double time_step);

/// The change of E - W since the start over the energy of the motion, against time; each curve ends
/// where it has changed by `most` of it.
/// @param motion [J].
Plot account_plot(const std::string& id, const std::string& title,
                  const std::vector<EnergyCurve>& curves, double motion, double most);

/// The largest change so far, either way, on logarithmic axes: drift rises, what is bounded stays.
Plot largest_change_plot(const std::vector<EnergyCurve>& curves, double motion);

}  // namespace weft::lab
