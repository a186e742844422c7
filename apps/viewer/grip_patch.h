// The patch of cloth that a hand takes hold of.
#pragma once

#include <span>
#include <vector>

#include "weft/simulation.h"

namespace weft::viewer {

/// Grips on the particles around one, softer outward, each keeping its place in the patch.
class GripPatch {
public:
    /// @param mass of the whole cloth [kg]: the springs together hold some tens of its weight.
    /// @param radius of the patch in the present positions [m]; `particle` always belongs to it.
    GripPatch(std::span<const Vec3d> positions, std::size_t particle, Vec3d grabbed_at,
              double radius, double mass);

    /// With the hand at a point [m].
    [[nodiscard]] std::vector<Grip> grips(Vec3d hand) const;

private:
    Vec3d grabbed_at_;
    std::vector<Grip> at_start_;
};

}  // namespace weft::viewer
