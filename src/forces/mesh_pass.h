// The fast path of a mesh: tables that a kernel reads straight through, and the kernel's functions.
// The readable twins are MeshSprings, MeshAir and the integrators' own loops.
//
// Slots are taken in slices, one slot a lane of a vector. A slice's springs stand in vectors too,
// the n-th neighbour of every lane in the n-th vector (sliced ELLPACK), so a lane sums its own
// particle's springs in the order of its table and nothing is written twice.
//
// A neighbour is read as one row {x, y, z, 0, vx, vy, vz, 0}, half a cache line in float and one in
// double, and a vector of neighbours is transposed in registers: gather instructions take several
// times as long. The rows are a copy of the state, made before its particles move, so a pass may
// move them in place. Neighbours stand near each other (cloth/mesh_order.h): on one thread the copy
// runs just ahead of the sums, and the rows are a ring that stays in the second-level cache. So do
// the forces on triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "forces/plate_force.h"
#include "math/instruction_sets.h"
#include "math/vec3_array.h"

namespace weft {

/// What a pass does with a particle's acceleration a.
enum class MeshUpdate {
    acceleration,  ///< writes it
    kick_drift,    ///< v += kick a, then x += drift v
};

inline constexpr std::size_t spring_kind_count = 3;

/// Constants of the springs of one kind, scaled by root_scale and for a width factor of 1.
template <typename Real>
struct MeshSpringConstants {
    Real stiffness = 0;  ///< k [N/m]
    Real damping = 0;    ///< c / root_scale^2 [N s/m]
};

/// Everything a pass needs; pointers belong to others and are aligned to cache lines, save those
/// of the state. "Vector" is a group of as many places as the instruction set has lanes.
template <typename Real>
struct MeshPass {
    static constexpr std::size_t row_size = 8;    ///< of a particle in `rows`
    static constexpr std::size_t third_size = 4;  ///< of a triangle in `thirds`

    Real* rows = nullptr;      ///< [slot & row_mask][row_size]
    std::size_t row_mask = 0;  ///< whole slices

    std::array<MeshSpringConstants<Real>, spring_kind_count> springs{};  ///< by SpringKind
    /// [slices * spring_kind_count + 1], where a slice's springs of a kind begin [vector].
    const std::uint32_t* spring_starts = nullptr;
    const std::uint32_t* neighbours = nullptr;  ///< [vector][lane], places in rows; padding: own
    const Real* tensions = nullptr;             ///< [vector][lane], k L / root_scale [N]
    const Real* widths = nullptr;  ///< [vector][lane], factor of k and c; nullptr: all are 1

    bool air = false;
    AirConstants<Real> air_constants{};
    const std::uint32_t* corners = nullptr;  ///< [vector][corner][lane], places in rows
    Real* thirds = nullptr;                  ///< [triangle & third_mask][third_size], [N]
    std::size_t third_mask = 0;              ///< whole vectors; behind them one third of zero
    const std::uint32_t* triangle_starts = nullptr;  ///< [slices + 1], where sums begin [vector]
    const std::uint32_t* triangles = nullptr;        ///< [vector][lane], places in thirds

    const Real* inverse_masses = nullptr;  ///< [slot], whole slices; 0: pinned, or padding
    Real drag = 0;                         ///< [kg/s]
    Vec3<Real> gravity{};

    Vec3<Real> wind{};  ///< [m/s]
    MeshUpdate update = MeshUpdate::acceleration;
    Real kick = 0, drift = 0;  ///< [s]
    std::array<Real*, 3> x{}, v{}, a{};
};

/// How many slots stand in a slice, for any set but scalar.
template <typename Real>
constexpr std::size_t mesh_lanes(InstructionSet set) {
    const std::size_t bytes = set == InstructionSet::avx512 ? 64
                              : set == InstructionSet::avx2 ? 32
                                                            : 16;
    return bytes / sizeof(Real);
}

/// Does a part of a pass for vectors [begin, end): slices, or vectors of triangles.
template <typename Real>
using MeshPassFunction = void (*)(const MeshPass<Real>&, std::size_t begin, std::size_t end);

/// The parts of a pass. A slice is copied before a triangle or a neighbour reads it, and moved
/// after all have; a triangle is found before a slice sums it.
template <typename Real>
struct MeshPassFunctions {
    MeshPassFunction<Real> copy_rows = nullptr;     ///< of slices
    MeshPassFunction<Real> find_thirds = nullptr;   ///< of vectors of triangles; only with air
    MeshPassFunction<Real> sum_and_move = nullptr;  ///< of slices
};

/// Compiled for an instruction set, any but scalar.
MeshPassFunctions<float> mesh_pass_single(InstructionSet set);
MeshPassFunctions<double> mesh_pass_double(InstructionSet set);

}  // namespace weft
