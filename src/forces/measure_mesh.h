// What is asked of a mesh's state once a frame: strain, energies, normals and copies, by loops over
// tables of slots. The readable twins are forces/energy.h and compute_normals(). Sums are kept
// block by block, so that any threads give the same bits.
#pragma once

#include <algorithm>
#include <array>
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
    [[nodiscard]] std::size_t block_count() const {
        return (reaches_.size() + block_size - 1) / block_size;
    }
    /// The strain of each block of springs.  @param out [block].
    void strain(View x, std::span<RatioRange<Real>> out) const;
    /// The spring of a block that is farthest from its rest length.
    [[nodiscard]] SpringStrain largest_strain(View x, std::size_t block) const;
    /// Of the springs of each block.  @param out [block].
    void energy(View x, std::span<Energy> out) const;

    /// As compute_normals().  @param out [particle].
    void normals(View x, std::span<Vec3f> out);
    /// @param out [particle].
    void copy(View x, std::span<Vec3d> out) const;
    void copy(View x, std::span<Vec3f> out) const;  ///< rounded

    /// Who stands at a slot.
    [[nodiscard]] std::span<const std::uint32_t> particles() const { return particles_; }

private:
    /// What strain needs, and is read every frame.
    struct Reach {
        std::uint32_t p = 0, q = 0;  ///< slots
        Real inverse_square = 0;     ///< 1 / L^2 [1/m2]
    };
    /// What energy needs besides.
    struct Store {
        double rest_length = 0.0;  ///< L [m]
        double stiffness = 0.0;    ///< k/2 [N/m]
    };
    static constexpr std::size_t block_size = 512;  // springs

    template <typename To>
    void copy_as(View x, std::span<Vec3<To>> out) const;
    void list_springs();
    void list_triangles();
    [[nodiscard]] std::size_t end_of(std::size_t block) const {
        return std::min((block + 1) * block_size, reaches_.size());
    }
    [[nodiscard]] Energy energy_of_block(View x, std::size_t block) const;

    const ClothModel& cloth_;
    std::vector<std::uint32_t> particles_;  ///< [slot]
    // Springs by their lower slot: neighbours are read together.
    std::vector<Reach> reaches_;
    std::vector<Store> stores_;
    std::vector<SpringKind> kinds_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;  ///< slots
    std::vector<std::uint32_t> first_around_;              ///< [slot + 1], into around_
    std::vector<std::uint32_t> around_;    ///< triangles, of a particle in the surface's order
    std::vector<Vec3<Real>> twice_areas_;  ///< [triangle], along its normal
};

extern template class MeshMeasures<float>;
extern template class MeshMeasures<double>;

}  // namespace weft
