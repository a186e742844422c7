// How wrinkled a cloth is, as a number.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/cloth_model.h"
#include "cloth/particle_state.h"

namespace weft::lab {

/// Measures the angle between neighbouring triangles of the drawn surface: 0 where it is smooth,
/// 180 degrees where it is folded back on itself.
class Wrinkles {
public:
    /// @param surface outlives this.
    explicit Wrinkles(const Surface& surface);

    /// Root mean square of the angle over all edges between two triangles [degrees]. A triangle
    /// without area has no direction: its edges do not count.
    [[nodiscard]] double angle(std::span<const Vec3d> positions) const;
    [[nodiscard]] double angle(const ClothModel& cloth, const ParticleState<double>& state) const;

    [[nodiscard]] std::size_t edge_count() const { return edges_.size(); }

private:
    const Surface* surface_;
    std::vector<std::array<std::uint32_t, 2>> edges_;  ///< of two triangles each
};

/// [particle] where a state has them.
std::vector<Vec3d> positions_of(const ClothModel& cloth, const ParticleState<double>& state);

}  // namespace weft::lab
