// The report as one HTML page that needs nothing beside it.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lab/report/report_layout.h"

namespace weft::lab {

/// The whole of report.html. Plots must be drawn.
/// @param directory of the report, for pictures and videos.
/// @param scenes their names; several: sections stand side by side, and findings are compared.
/// @throws Error (file) where a picture or video cannot be read.
std::string report_page(const std::filesystem::path& directory, const ReportHead& head,
                        std::span<const PlacedExperiment> experiments,
                        const std::vector<std::string>& scenes);

}  // namespace weft::lab
