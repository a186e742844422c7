// The frame loop that run and render share.
#pragma once

#include <optional>

#include "cli/progress.h"
#include "cli/run_summary.h"
#include "io/recording_queue.h"
#include "weft/simulation.h"

namespace weft {

/// Simulates until the scene's last frame, Ctrl-C, divergence or the failure of a recorder, and
/// fills in status, seconds, strain and divergence of the record.
/// @param queue gets every frame, frame 0 included; null: nothing is recorded.
void simulate(Simulation& simulation, RecordingQueue* queue, Progress& progress, RunRecord& record);

/// What a user should know before a run: a step beyond the stable one.
std::vector<std::string> warnings_before(const Simulation& simulation);

/// The plan of recording a whole scene into a directory.
RecordingPlan recording_plan(const Simulation& simulation, const std::filesystem::path& directory,
                             const std::string& stem);

/// Says why a run diverged, on standard error.
void report_divergence(const Divergence& divergence);

}  // namespace weft
