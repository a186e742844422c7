// What is asked of a grid's state once a frame, each in one sweep over its rows: strain, energies,
// normals, copies and hashes. Functions are compiled for every instruction set; the readable twins
// are forces/energy.h, compute_normals() and plain loops. Sums are kept row by row, so that any
// threads give the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cloth/grid_cloth.h"
#include "math/instruction_sets.h"
#include "math/vec3_array.h"
#include "weft/measures.h"

namespace weft {

/// The constants that measuring needs; pointers belong to others.
template <typename Real>
struct GridMeasure {
    struct Family {
        double rest_length = 0;         ///< L [m]
        Real inverse_square = 0;        ///< 1 / L^2 [1/m2]
        const Real* columns = nullptr;  ///< [stride], 1: the column owns springs; 0: it has none
        const double* stiffness = nullptr;  ///< [stride], k/2 but for the row's factor [N/m]
        const double* rows = nullptr;       ///< [rows], factor on it; 0: no springs
        bool inner = false;                 ///< columns away from the borders own springs
    };
    std::size_t columns = 0, rows = 0, stride = 0;
    std::array<Family, grid_family_count> families;
    bool left_edge = false;          ///< column 0 differs from the inner ones
    const double* masses = nullptr;  ///< [particle] [kg]
    Vec3d gravity{};                 ///< [m/s2]
};

/// The squared lengths of some springs, each over that at rest: from the smallest to the largest.
template <typename Real>
struct RatioRange {
    Real smallest = 1, largest = 1;  ///< largest is infinite where a state is not finite
};

/// The sweeps, each over rows [begin, end).
template <typename Real>
struct GridMeasures {
    using View = ConstVec3View<Real>;
    /// Of the springs that each row owns.  @param out [row].
    void (*strain)(const GridMeasure<Real>& grid, View x, View v, std::size_t begin,
                   std::size_t end, RatioRange<Real>* out) = nullptr;
    /// Of each row's particles and the springs it owns.  @param out [row].
    void (*energy)(const GridMeasure<Real>& grid, View x, View v, std::size_t begin,
                   std::size_t end, Energy* out) = nullptr;
    /// Of the particles of a row, as compute_normals().  @param out [particle].
    void (*normals)(const GridMeasure<Real>& grid, View x, std::size_t begin, std::size_t end,
                    Vec3f* out) = nullptr;
    /// @param out [particle].
    void (*copy)(const GridMeasure<Real>& grid, View x, std::size_t begin, std::size_t end,
                 Vec3d* out) = nullptr;
    /// The same, rounded to float.
    void (*copy_rounded)(const GridMeasure<Real>& grid, View x, std::size_t begin, std::size_t end,
                         Vec3f* out) = nullptr;
    /// The sum of mix_bits(bits of value n + key + n key_step), wrapping.
    std::uint64_t (*hash)(const Real* values, std::size_t count, std::uint64_t key,
                          std::uint64_t key_step) = nullptr;
};

/// Those compiled for an instruction set; nullptr for scalar.
GridMeasures<float> grid_measures_single(InstructionSet set);
GridMeasures<double> grid_measures_double(InstructionSet set);

}  // namespace weft
