// The measurements behind the experiment "stability".
#pragma once

#include <string_view>
#include <vector>

#include "lab/laboratory.h"
#include "lab/stability/resting_cloth.h"

namespace weft::lab {

/// {"modes": [[omega, damping rate], ...], "complete": bool} of the calm scene.
Trial spectrum_trial(const SceneDescription& scene, std::size_t count);

/// Of a method that has a limit: {"stable", "unstable", "found", "flights", "steps", "resolution"},
/// and under "curve" [dt / predicted limit, ln of the growth a step] for each of `parts`.
Trial limit_trial(const SceneDescription& scene, std::string_view method, double predicted,
                  const Search& search, const std::vector<double>& parts);

/// Of a method that is stable at no step: {"rate", "steps"}, ln of the growth a step.
Trial growth_trial(const SceneDescription& scene, std::string_view method, double time_step,
                   std::size_t steps);

/// Of a method without a limit, far beyond those of explicit ones: the nudge of the calm cloth
/// {"total": ln of its growth, "steps", "failure"}, and the scene as it is, under "scene":
/// {"steps", "of", "strain", "failure"}.
Trial beyond_trial(const SceneDescription& scene, std::string_view method, double time_step,
                   std::size_t steps);

}  // namespace weft::lab
