// Spring forces on a mesh: every particle sums its own springs in the order of a neighbour table,
// so that no two particles write one place and any split over threads gives the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth/cloth_model.h"
#include "math/vec3_array.h"

namespace weft {

template <typename Real>
class MeshSprings {
public:
    explicit MeshSprings(const ClothModel& cloth);

    /// Adds to f the spring and dashpot forces on slots [begin, end); the formula is that of
    /// GridSprings.
    void add_forces(ConstVec3View<Real> x, ConstVec3View<Real> v, Vec3View<Real> f,
                    std::size_t begin, std::size_t end) const;

private:
    struct Neighbour {
        std::uint32_t slot = 0;
        Real rest_length = 0;  ///< [m]
        Real stiffness = 0;    ///< [N/m]
        Real damping = 0;      ///< [N s/m]
    };
    std::vector<std::uint32_t> first_;  ///< [slot + 1], index of its first neighbour
    std::vector<Neighbour> neighbours_;
};

extern template class MeshSprings<float>;
extern template class MeshSprings<double>;

}  // namespace weft
