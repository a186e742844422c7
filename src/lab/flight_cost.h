// What flights cost, in evaluations of one particle's forces on a grid without air (3.5 ns on one
// core of 2026): experiments bound their work by counting, so that the same study is always as
// long.
#pragma once

#include <string_view>

#include "weft/scene.h"

namespace weft::lab {

/// Of an evaluation of the scene's forces, a particle.
double evaluation_cost(const SceneDescription& scene);

/// Evaluations that a step is worth, roughly; of implicit methods, where their systems are solved
/// nearly exactly or to the usual tolerance.
double step_cost(std::string_view method, bool exact);

/// Of ClothSystem::power(), a particle.
double power_cost(const SceneDescription& scene);

}  // namespace weft::lab
