// How much memory a scene takes; part of check_scene (weft/scene.h).
#pragma once

#include "weft/scene.h"

namespace weft {

/// Particles of the cloth: columns times rows, or the mesh's vertices (welding them may leave
/// fewer).
double particle_estimate(const SceneDescription& scene);

/// Memory that running the scene takes, recorders included [bytes]: about 250 a particle for the
/// cloth, 300 for frames on their way to the recorders, and with format "glb" 24 for each particle
/// of each recorded frame, of which glb keeps 250 at most. A floating number, as it may be beyond
/// any integer.
double estimate_memory(const SceneDescription& scene);

/// Memory of this machine [bytes]; infinite where the system does not tell.
double machine_memory();

}  // namespace weft
