// What is asked of a mesh's state once a frame: strain, energies, normals and copies, by loops over
// tables of slots. The readable twins are forces/energy.h and compute_normals(). Sums are kept
// block by block, so that any threads give the same bits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/cloth_model.h"
#include "forces/measure_grid.h"
#include "math/vec3_array.h"
#include "weft/measures.h"

namespace weft {

template <typename Real>
class MeshMeasures {
public:
    using View = ConstVec3View<Real>;

    /// @param cloth a mesh, or nothing is kept; outlives this.
    explicit MeshMeasures(const ClothModel& cloth);

    /// How many ranges strain() gives.
    [[nodiscard]] std::size_t block_count() const { return blocks_.size(); }
    /// The strain of each block of springs.  @param out [block].
    void strain(View x, std::span<RatioRange<Real>> out) const;
    /// The spring of a block that is farthest from its rest length.
    [[nodiscard]] SpringStrain largest_strain(View x, std::size_t block) const;
    /// Of the springs of each block, in their kind.  @param out [block].
    void energy(View x, std::span<Energy> out) const;

    /// As compute_normals().  @param out [particle].
    void normals(View x, std::span<Vec3f> out);
    /// @param out [particle].
    void copy(View x, std::span<Vec3d> out) const;

    /// Who stands at a slot.
    [[nodiscard]] std::span<const std::uint32_t> particles() const { return particles_; }

private:
    struct MeasuredSpring {
        std::uint32_t p = 0, q = 0;  ///< slots
        Real inverse_square = 0;     ///< 1 / L^2 [1/m2]
        std::uint32_t number = 0;    ///< in cloth.springs
    };
    /// Springs [begin, end) of the table, of one kind.
    struct Block {
        std::size_t begin = 0, end = 0;
        SpringKind kind = SpringKind::structural;
    };

    void list_springs();
    void list_triangles();
    [[nodiscard]] double stored(View x, const MeasuredSpring& spring) const;

    const ClothModel& cloth_;
    std::vector<std::uint32_t> particles_;  ///< [slot]
    std::vector<MeasuredSpring> springs_;  ///< by kind, then by slots: neighbours are read together
    std::vector<Block> blocks_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;  ///< slots
    std::vector<std::uint32_t> first_around_;              ///< [slot + 1], into around_
    std::vector<std::uint32_t> around_;    ///< triangles, of a particle in the surface's order
    std::vector<Vec3<Real>> twice_areas_;  ///< [triangle], along its normal
};

extern template class MeshMeasures<float>;
extern template class MeshMeasures<double>;

}  // namespace weft
