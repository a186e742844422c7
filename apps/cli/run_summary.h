// summary.json: what was run, on what, how long it took, and what came of it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "weft/simulation.h"

namespace weft {

/// What a run leaves behind besides the simulation itself.
struct RunRecord {
    std::string status = "done";  ///< "done", "interrupted", "diverged" or "failed"
    double building_seconds = 0.0, stepping_seconds = 0.0, waiting_seconds = 0.0;
    double recording_seconds = 0.0;  ///< on the recorders' own thread
    double total_seconds = 0.0;
    int halvings = 0;
    Energy start_energy;
    SpringStrain largest_strain;  ///< of all frames
    std::size_t largest_strain_frame = 0;
    std::optional<Divergence> divergence;
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path> files;
};

nlohmann::ordered_json run_summary(const Simulation& simulation, const RunRecord& record);

/// Stable step of every integrator as JSON, null where none is and "any" where nothing limits it.
nlohmann::ordered_json stable_steps_json(const Simulation& simulation);

}  // namespace weft
