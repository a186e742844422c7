// The answer of the experiment "energy" in one sentence.
#pragma once

#include <string>
#include <vector>

#include "lab/energy/energy_leg.h"

namespace weft::lab {

/// Who keeps, loses and gains energy, and how fast.
/// @param legs a flight of every method.  @param beginning of the sentence.
std::string energy_answer(const std::vector<const EnergyLeg*>& legs, const EnergyScale& scale,
                          const std::string& beginning);

}  // namespace weft::lab
