// Finding out that, where and when a run diverged.
#pragma once

#include <optional>

#include "cloth/cloth_model.h"
#include "cloth/particle_state.h"
#include "forces/measure_cloth.h"
#include "integrators/integrator.h"
#include "weft/simulation.h"

namespace weft {

/// @return what is wrong with the state (spring or particle filled in, message not yet), if
/// anything.
/// @param check that of the state: most states are seen to be sound from it alone.
template <typename Real>
std::optional<Divergence> find_divergence(const ClothModel& cloth, const ParticleState<Real>& state,
                                          const StrainCheck& check);

/// A step that could not be made, told as a divergence.
/// @param failed has step, time and time_step of it, and the stable step.
void describe_failure(Divergence& failed, const StepFailure& failure, std::string_view method);

/// Fills in message and advice.
void describe_divergence(Divergence& divergence, const ClothModel& cloth, std::string_view method);

}  // namespace weft
