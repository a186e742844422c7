// The fast products with the stiffness and damping matrices of forces/linearised.h, symmetric in
// mass-scaled co-ordinates: out = s M^-1/2 A M^-1/2 u, and what u.out and out.out are on the way.
// The readable twins are stiffness_product and damping_product.
//
// On a grid, one sweep over rows as in forces/grid_pass.h, but out of place. The rows of M^-1/2 u
// that a row's springs end on wait in a ring of three. On a mesh, every particle sums its own
// springs: slices of as many slots as a vector has lanes, a spring of each slot a vector.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cloth/grid_cloth.h"
#include "math/instruction_sets.h"

namespace weft {

enum class LinearMatrix {
    stiffness,  ///< K
    damping,    ///< C
};

/// Scaled constants of a spring (see root_scale in math/simd_targets.h).
template <typename Real>
struct LinearSpring {
    Real stiffness = 0;         ///< k [N/m]
    Real scaled_stiffness = 0;  ///< k / root_scale^2 [N/m]
    Real scaled_tension = 0;    ///< k L / root_scale^3 [N]
    Real scaled_damping = 0;    ///< c / root_scale^2 [N s/m]
};

/// The constants of all families along a row.
template <typename Real>
struct LinearRow {
    using Families = std::array<LinearSpring<Real>, grid_family_count>;
    Families inner;  ///< away from the left and right border
    Families edge;   ///< near them: to be multiplied by the column's factor
};

/// The sums over one block of particles, a grid's row or a mesh's slices.
struct LinearSums {
    double in_out = 0.0;   ///< s u.out: of what the pass has at hand
    double out_out = 0.0;  ///< out.out
};

/// A product on a grid; pointers belong to others.
template <typename Real>
struct LinearGridPass {
    LinearMatrix matrix = LinearMatrix::stiffness;
    std::size_t columns = 0, rows = 0, stride = 0;
    std::array<LinearRow<Real>, 6> row_constants;                 ///< by row_kind()
    std::array<const Real*, grid_family_count> column_factors{};  ///< [stride], 0: no spring
    bool left_edge = false;                     ///< column 0 differs from the inner ones
    const Real* root_inverse_masses = nullptr;  ///< M^-1/2 [slot], 0: pinned, or padding
    Real drag = 0;                              ///< of C [kg/s]
    Real scale = 1;                             ///< s
    std::array<const Real*, 3> x{}, u{};
    std::array<Real*, 3> out{};
    LinearSums* sums = nullptr;  ///< [rows]

    /// Border row or not, and whether 0, 1, 2 or more rows lie below.
    [[nodiscard]] std::size_t row_kind(std::size_t j) const {
        const std::size_t below = rows - 1 - j;
        return 2 * (below < 2 ? below : 2) + (j == 0 || below == 0 ? 1 : 0);
    }
};

/// A band of rows and its scratch memory: rows of scratch_stride(), all of them zero at first.
template <typename Real>
struct LinearBand {
    static constexpr std::size_t ring_lines = 9;  ///< three rows of three components of M^-1/2 u
    static constexpr std::size_t sum_lines = 9;   ///< and of what springs add to rows below
    static constexpr std::size_t line_count = ring_lines + sum_lines;

    std::size_t row_begin = 0, row_end = 0;
    Real* lines = nullptr;  ///< [line_count][line_stride(stride)]

    /// Room for a vector that begins two columns before the end; never whole pages of 4 KiB, or
    /// the lines would share one set of the first-level cache.
    static constexpr std::size_t line_stride(std::size_t stride) {
        return (stride + 16) % 512 == 0 ? stride + 32 : stride + 16;
    }
};

template <typename Real>
using LinearGridFunction = void (*)(const LinearGridPass<Real>&, const LinearBand<Real>&);

LinearGridFunction<float> linear_grid_single(InstructionSet set);
LinearGridFunction<double> linear_grid_double(InstructionSet set);

/// Constants of the springs of one kind, scaled as in LinearSpring and for a width factor of 1.
template <typename Real>
struct LinearKind {
    Real stiffness = 0;       ///< k [N/m]
    Real scaled_damping = 0;  ///< c / root_scale^2 [N s/m]
};

/// A product on a mesh; pointers belong to others and are aligned to cache lines, save x, u, out.
/// Its springs stand as in MeshSpringTables. Records are the vectors of one slot each, {x, y, z,
/// 0}.
template <typename Real>
struct LinearMeshPass {
    LinearMatrix matrix = LinearMatrix::stiffness;
    std::array<LinearKind<Real>, 3> kinds{};  ///< by SpringKind
    /// [3 slices + 1], where a slice's springs of a kind begin [vector].
    const std::uint32_t* spring_starts = nullptr;
    const std::uint32_t* neighbours = nullptr;  ///< [vector][lane], 4 slot; padding: the lane's own
    const Real* tensions = nullptr;             ///< [vector][lane], k L / root_scale [N]
    const Real* widths = nullptr;  ///< [vector][lane], factor of k and c; nullptr: all are 1
    const Real* root_inverse_masses = nullptr;  ///< M^-1/2 [slot], 0: pinned; whole slices
    Real drag = 0;                              ///< of C [kg/s]
    Real scale = 1;                             ///< s
    const Real *x_records = nullptr, *u_records = nullptr;  ///< of x, s M^-1/2 u; whole slices
    std::array<const Real*, 3> x{}, u{};                    ///< [slot], readable in whole slices
    std::array<Real*, 3> out{};                             ///< [slot], with room for whole slices
};

/// The product on slices [begin, end), and its sums.
template <typename Real>
using LinearMeshFunction = LinearSums (*)(const LinearMeshPass<Real>&, std::size_t begin,
                                          std::size_t end);

LinearMeshFunction<float> linear_mesh_single(InstructionSet set);
LinearMeshFunction<double> linear_mesh_double(InstructionSet set);

/// Vectors to be written as records: factor scales[s] u[s].
template <typename Real>
struct LinearRecords {
    std::array<const Real*, 3> u{};  ///< [slot], readable in whole slices
    const Real* scales = nullptr;    ///< [slot], whole slices; nullptr: all are 1
    Real factor = 1;
    Real* records = nullptr;  ///< [4 slot], whole slices
};

/// Writes those of slices [begin, end).
template <typename Real>
using LinearRecordsFunction = void (*)(const LinearRecords<Real>&, std::size_t begin,
                                       std::size_t end);

LinearRecordsFunction<float> linear_records_single(InstructionSet set);
LinearRecordsFunction<double> linear_records_double(InstructionSet set);

}  // namespace weft
