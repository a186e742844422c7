// How large a step is stable: the cloth linearised at a state, and every method's limit on it.
#pragma once

#include <string_view>
#include <vector>

#include "math/largest_eigenvalue.h"
#include "simulation/cloth_system.h"
#include "weft/simulation.h"

namespace weft {

/// A damped mode x'' = -omega^2 x - 2 zeta omega x'.
struct Mode {
    double omega = 0.0;         ///< [1/s]
    double damping_rate = 0.0;  ///< 2 zeta omega [1/s]
};

/// The modes that limit a step: the one of the largest frequency, the one most damped, and the
/// slowest under drag alone. `least_damped` bounds from below how much the highest mode is damped
/// (the smallest ratio c/k of any spring): it limits methods that need damping to be stable.
struct StabilityModes {
    std::vector<Mode> modes;
    Mode least_damped;

    /// Largest stable step of a method [s]; infinity where nothing limits it, 0 where none is.
    [[nodiscard]] double stable_step(std::string_view method) const;
};

/// Analyses the springs linearised at positions x.
/// @param fastest_mode becomes the fastest mode, in mass-scaled co-ordinates.
template <typename Real>
StabilityModes stability_modes(const ClothModel& cloth, const ForcesDescription& forces,
                               const ClothSystem<Real>& system, ConstVec3View<Real> x,
                               Vec3Array<Real>& fastest_mode);

/// Follows omega_max^2 while the cloth moves: so many steps of power iteration from `vector`, the
/// last mode found. The result is never above the true value [1/s2].
template <typename Real>
double follow_largest_stiffness(const ClothModel& cloth, const ClothSystem<Real>& system,
                                ConstVec3View<Real> x, Vec3Array<Real>& vector, int products);

}  // namespace weft
