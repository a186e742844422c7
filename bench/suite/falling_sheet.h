// The sheet in motion that implicit methods are timed on and all methods' accuracy is measured on.
#pragma once

#include <string_view>

#include "weft/scene.h"
#include "weft/simulation.h"

namespace weft::bench {

/// A sheet of 1 m x 1 m and 0.2 kg that lies flat, held at two corners of one edge, and is let go.
/// Each structural spring has 1000 N/m, each shear spring 500, each bend spring 100, at every
/// resolution; nothing damps. In double, 60 frames a second, at the method's own step.
SceneDescription falling_sheet(int size, std::string_view method);

/// A simulation of the scene from a sheet with ripples 2 mm high: a flat one could not choose which
/// way to buckle.
Simulation let_fall(const SceneDescription& scene);

}  // namespace weft::bench
