// The report of a study: report.html, and every number as CSV and JSON, every plot as SVG and PNG.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/section.h"

namespace weft::lab {

/// What a report says above its sections.
struct ReportHead {
    std::string title;    ///< "The laboratory: Sheet held at two corners"
    std::string scene;    ///< the scene's name
    std::string command;  ///< that makes it again
    std::vector<std::string>
        facts;           ///< a line each: particles, springs, omega_max, machine, version
    bool quick = false;  ///< made with --quick: said at the top
};

/// The sections of one scene; a comparison has two.
struct SceneSections {
    std::string scene;  ///< name; stands beside titles where there are several
    std::vector<Section> sections;
};

/// Writes into `directory`: report.html (self-contained), lab.json, and for every section and scene
/// SECTION/ID.csv, ID.svg, ID.png. Files of an earlier report are replaced; nothing half-written
/// stands under a final name.
/// @return the files written.
/// @throws Error (file), also where gnuplot is missing or fails.
std::vector<std::filesystem::path> write_report(const std::filesystem::path& directory,
                                                const ReportHead& head,
                                                const std::vector<SceneSections>& scenes);

/// @throws Error (file) where the program gnuplot cannot be run, naming the package.
void check_plotting();

}  // namespace weft::lab
