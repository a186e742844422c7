// The findings of all experiments in one table: of two scenes side by side.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lab/report/report_layout.h"

namespace weft::lab {

/// A row a finding: its experiment, name and unit, its value on each scene, and of two scenes the
/// ratio second : first. A finding that a scene lacks is a cell without a value.
/// @param scenes the names, in the order of the columns.
Table findings_table(std::span<const PlacedExperiment> experiments,
                     const std::vector<std::string>& scenes);

}  // namespace weft::lab
