// Which method integrator.method = "auto" stands for.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cloth/cloth_model.h"
#include "simulation/stability.h"

namespace weft {

struct MethodChoice {
    std::string method;
    std::string reason;  ///< in one line; empty where the scene names the method
};

/// The scene's method; for "auto" the cheaper of velocity-verlet with stable steps and tr-bdf2 with
/// steps for accuracy, or the one that the given step suits. Decided by counting, not by timing:
/// the same scene is run by the same method everywhere.
MethodChoice choose_method(const SceneDescription& scene, const ClothModel& cloth,
                           const StabilityModes& modes);

/// Steps a frame that a method takes on its own: 0.9 of its stable step; where it has none, its
/// auto_step; one where it is adaptive. 0: it is stable at no step.
std::size_t automatic_steps(const SceneDescription& scene, std::string_view method,
                            const StabilityModes& modes);

/// Steps a frame of a scene: its time_step's, or the automatic ones; one where the method is
/// adaptive.
/// @throws Error (usage) where the step is automatic and the method stable at none.
std::size_t steps_a_frame(const SceneDescription& scene, std::string_view method,
                          const StabilityModes& modes);

/// The tolerance of a scene [m]: its own, or for implicit methods a part of the cloth's size. None:
/// an adaptive method's own.
std::optional<double> solver_tolerance(const SceneDescription& scene, const ClothModel& cloth,
                                       std::string_view method);

/// Smallest whole number of steps in a frame that keeps each at most dt; a step that fits a whole
/// number of times but for rounding is taken at that number.
std::size_t steps_in_frame(double frame_length, double dt);

}  // namespace weft
