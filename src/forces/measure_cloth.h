// Everything that is asked of a cloth's state once a frame, at the speed of the kernels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/cloth_model.h"
#include "forces/measure_grid.h"
#include "forces/measure_mesh.h"
#include "math/vec3_array.h"
#include "weft/measures.h"

namespace weft {

/// Whether a state is sound, by one sweep over it.
struct StrainCheck {
    bool finite = true;     ///< all of x and v
    double strain = 0.0;    ///< the largest |l / L - 1|, rounded as the state is
    std::size_t place = 0;  ///< the row or block of the spring that has it
};

/// Measures by the kernels of an instruction set; with `scalar`, by the readable twins of
/// forces/energy.h. x and v are [slot]. Keeps scratch memory: use from one thread at a time.
template <typename Real>
class ClothMeasures {
public:
    using View = ConstVec3View<Real>;

    /// @param cloth, forces outlive this.
    ClothMeasures(const ClothModel& cloth, const ForcesDescription& forces, InstructionSet set);

    StrainCheck check(View x, View v);

    /// The spring farthest from its rest length, as largest_strain(), but that of two within
    /// rounding of the state's precision either may be named.
    /// @param check that of this x.
    [[nodiscard]] SpringStrain largest_strain(View x, const StrainCheck& check) const;

    /// As energy(), but for the order of sums.
    Energy energy(View x, View v);

    /// As compute_normals(), in the state's precision.  @param out [particle].
    void normals(View x, std::span<Vec3f> out);
    /// x or v as it is.  @param out [particle].
    void copy(View x, std::span<Vec3d> out) const;
    void copy(View x, std::span<Vec3f> out) const;  ///< rounded

    /// Of the bits of x and v by particle, however they stand in memory.
    [[nodiscard]] std::uint64_t state_hash(View x, View v) const;

private:
    struct Family {
        std::vector<Real> columns;            ///< [stride]
        std::vector<double> stiffness, rows;  ///< [stride], [rows]
    };

    [[nodiscard]] bool uses_twins() const { return set_ == InstructionSet::scalar; }
    void set_grid();
    void set_family(std::size_t n);
    [[nodiscard]] SpringStrain largest_strain_of_row(View x, std::size_t j) const;
    void mesh_particle_energy(View x, View v);
    [[nodiscard]] std::uint64_t component_hash(const Real* values, std::uint64_t component) const;

    const ClothModel& cloth_;
    const ForcesDescription& forces_;
    InstructionSet set_;
    GridMeasures<Real> sweeps_;
    GridMeasure<Real> grid_;
    std::array<Family, grid_family_count> families_;
    MeshMeasures<Real> mesh_;
    std::vector<RatioRange<Real>> ranges_;  ///< [row], or [block]
    std::vector<Energy> energies_;          ///< [row], or [block] and then [block of particles]
};

extern template class ClothMeasures<float>;
extern template class ClothMeasures<double>;

}  // namespace weft
