// How the air resists a cloth's motion: the derivative of its force, for implicit methods.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cloth/cloth_model.h"
#include "forces/newton_matrix.h"
#include "forces/plate_force.h"

namespace weft {

/// D = -d plate_force_third / d v for a plate that moves with velocity v, its symmetric positive
/// part: with Q = |N| rho C_d / 4 / R (2 v_n^2 + |v_r|^2 - (0.222 |v_n| |v_r|^2 + 0.283 |v_r|
/// v_n^2) / R), R = 0.222 |v_n| + 0.283 |v_r|,
///     3 D = Q n n^T + |N| rho C_f / 2 (|v_t| (I - n n^T) + v_t v_t^T / |v_t|).
/// Left out is how the normal force changes with the wind along the plate: it is not symmetric.
/// @return [xx, xy, xz, yy, yz, zz] [kg/s].
std::array<double, 6> plate_damping_third(const AirConstants<double>& air,
                                          Vec3<double> relative_wind, Vec3<double> normal);

/// The air's damping of a cloth, lumped: what a triangle's corners do to each other is counted at
/// the corner itself, so that a cloth moving as a whole is damped as it should be.
class AirDamping {
public:
    AirDamping(const WindDescription& wind, const ClothModel& cloth);

    /// Adds factor times every particle's D to its block.
    void add(Vec3<double> wind, ConstVec3View<double> x, ConstVec3View<double> v, double factor,
             SymmetricBlocks<double>& blocks) const;

private:
    AirConstants<double> constants_;
    std::vector<std::array<std::uint32_t, 3>> corners_;  ///< [triangle], slots
};

}  // namespace weft
