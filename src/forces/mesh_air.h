// The force of the air on a mesh, per triangle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth/particle_layout.h"
#include "forces/plate_force.h"
#include "math/vec3_array.h"
#include "weft/frame.h"
#include "weft/scene.h"

namespace weft {

/// Air forces on a surface whose triangles join any particles: first every triangle's force, then
/// every particle's sum over its triangles, in the order of the triangles.
template <typename Real>
class MeshAir {
public:
    MeshAir(const WindDescription& wind, const Surface& surface, const ParticleLayout& layout);

    [[nodiscard]] std::size_t triangle_count() const { return corners_.size(); }

    /// Computes the forces of triangles [begin, end) in the wind [m/s]; call before add_forces.
    void compute(Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v, std::size_t begin,
                 std::size_t end);

    /// Adds to f the force on slots [begin, end).
    void add_forces(Vec3View<Real> f, std::size_t begin, std::size_t end) const;

    /// Rate of work of the forces last computed [W].
    [[nodiscard]] double power(ConstVec3View<Real> v) const;

private:
    AirConstants<Real> constants_;
    std::vector<std::array<std::uint32_t, 3>> corners_;  ///< [triangle], slots
    std::vector<std::uint32_t> first_, triangles_;       ///< of each slot
    Vec3Array<Real> thirds_;                             ///< [triangle] [N]
};

extern template class MeshAir<float>;
extern template class MeshAir<double>;

}  // namespace weft
