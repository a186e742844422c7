// The fast path of a grid: one sweep over its rows that computes every spring once and the air on
// every triangle, and at once does with the force what a step asks for. The readable twins are
// GridSprings, GridAir and the integrators' own loops.
//
// A row's sweep looks only forward: owner (i, j) computes its springs to (i+1, j), (i+2, j),
// (i, j+1), (i, j+2), (i+1, j+1) and the one from (i+1, j) to (i, j+1), and its quad's two
// triangles. What these put on its own row goes on from vector to vector in registers, what they
// put on the next two rows waits in line buffers that stay in the first-level cache. So when a
// vector of row j is done, nothing needs its old position any more: it may move in place.
//
// Bands of rows on several threads give the bits of one sweep: a band first sweeps the two rows
// above it without moving them, from copies made before anything moved (GridBand::halo).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cloth/grid_cloth.h"
#include "forces/plate_force.h"
#include "math/instruction_sets.h"
#include "math/vec3_array.h"

namespace weft {

/// What a pass does with a particle's acceleration a.
enum class GridUpdate {
    acceleration,  ///< writes it
    kick_drift,    ///< v += kick a, then x += drift v
    verlet,  ///< velocity Verlet: x += h v + h^2/2 a, v += h a; then v += h/2 (a+ - a), a = a+
};

/// The scaled constants of one family of springs along a row (see root_scale).
template <typename Real>
struct GridFamilyConstants {
    Real stiffness = 0;  ///< k [N/m]
    Real tension = 0;    ///< k L / root_scale [N]
    Real damping = 0;    ///< c / root_scale^2 [N s/m]
};

/// The constants of all families along a row.
template <typename Real>
struct GridRowConstants {
    using Families = std::array<GridFamilyConstants<Real>, grid_family_count>;
    Families inner;  ///< away from the left and right border
    Families edge;   ///< near them: to be multiplied by the column's factor
    bool has_triangles = false;
};

/// A particle that is put where its pin says before forces are computed.
template <typename Real>
struct PinTarget {
    std::size_t slot = 0;
    Vec3<Real> x{}, v{};
};

/// Another order in memory, for a state that is larger than the caches next to the core. A row's
/// columns are cut into as many strips as a vector has lanes: lane l of vector n is column
/// l length + n, so that what stands n columns on is n vectors on, in the same lane, and needs no
/// shuffle (Henretty et al., Data layout transformation for stencil computations on short-vector
/// SIMD architectures, CC 2011). A vector's particles and all that moves them are a block of lines:
/// x, y, z, vx, vy, vz, 1/m, and for velocity Verlet ax, ay, az; so a row is one stream of memory.
/// Two blocks after a row's last hold what stands right of it, the first two a lane down.
template <typename Real>
struct GridStrips {
    static constexpr std::size_t blocks_beyond = 2;
    static constexpr std::size_t lines_of(GridUpdate update) {
        return update == GridUpdate::verlet ? 10 : 7;
    }

    /// Numbers from a row to the next. Rows are never a whole number of pages apart: a store to one
    /// would seem to touch the next.
    static constexpr std::size_t size_of_row(std::size_t length, std::size_t block) {
        const std::size_t size = (length + blocks_beyond) * block;
        return size * sizeof(Real) % 4096 == 0 ? size + block : size;
    }

    Real* blocks = nullptr;    ///< not null: the pass moves these in place of x, v and a
    std::size_t length = 0;    ///< columns of a strip, vectors of a row
    std::size_t row_size = 0;  ///< size_of_row()
};

/// Everything a pass needs; views and pointers belong to others.
template <typename Real>
struct GridPass {
    std::size_t columns = 0, rows = 0, stride = 0;
    /// By row_kind(): border row or not, and whether 0, 1, 2 or more rows lie below.
    std::array<GridRowConstants<Real>, 6> row_constants;
    std::array<const Real*, grid_family_count> column_factors{};  ///< [stride], 0: no spring
    const Real* triangle_factors = nullptr;                       ///< [stride], 1 or 0
    bool left_edge = false;  ///< column 0 differs from the inner ones
    bool damped = false;     ///< some spring has a dashpot
    bool air = false;
    AirConstants<Real> air_constants{};
    const Real* inverse_masses = nullptr;  ///< [slot], 0: pinned, or padding
    Real drag = 0;                         ///< [kg/s]
    Vec3<Real> gravity{};

    Vec3<Real> wind{};  ///< [m/s]
    GridUpdate update = GridUpdate::acceleration;
    Real kick = 0, drift = 0;  ///< of kick_drift; of verlet: kick is h [s]
    /// Not null: the same with the next wind, kick and drift, to be done in the same sweep, two
    /// rows behind, so that the state comes from far once for both. Only of kick_drift in strips,
    /// on one band.
    const GridPass* second = nullptr;
    std::array<Real*, 3> x{}, v{}, a{};
    GridStrips<Real> strips;
    const PinTarget<Real>* pins = nullptr;  ///< moving pins by rising slot; verlet only
    std::size_t pin_count = 0;

    [[nodiscard]] std::size_t row_kind(std::size_t j) const {
        const std::size_t below = rows - 1 - j;
        return 2 * (below < 2 ? below : 2) + (j == 0 || below == 0 ? 1 : 0);
    }
};

/// A band of rows and its scratch memory.
template <typename Real>
struct GridBand {
    static constexpr std::size_t halo_rows = 4;    ///< two above, two below
    static constexpr std::size_t halo_arrays = 9;  ///< components of x, v, a
    static constexpr std::size_t line_count = 9;   ///< three rows of three components

    std::size_t row_begin = 0, row_end = 0;
    Real* lines = nullptr;  ///< [line_count][stride], and of a second pass as many
    /// [halo_arrays][halo_rows][stride], the rows around the band before the pass; nullptr: the
    /// band is the whole grid, or the pass moves nothing. Of strips: [halo_rows][row_size].
    Real* halo = nullptr;

    /// Where row j, one of those around the band, stands in the halo.
    [[nodiscard]] std::size_t halo_place(std::size_t j) const {
        return j < row_begin ? j + 2 - row_begin : j - row_end + 2;
    }
};

template <typename Real>
using GridPassFunction = void (*)(const GridPass<Real>&, const GridBand<Real>&);

/// The pass compiled for an instruction set; nullptr for scalar.
GridPassFunction<float> grid_pass_single(InstructionSet set);
GridPassFunction<double> grid_pass_double(InstructionSet set);

}  // namespace weft
