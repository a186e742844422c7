// The tables that a mesh's pass reads, built once from the cloth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth/cloth_model.h"
#include "forces/mesh_pass.h"
#include "math/line_aligned.h"

namespace weft {

/// Lists of what every slot has, as vectors: the n-th of each lane's list stands in the list's n-th
/// vector, lists are as long as the longest of their slice.
struct SlicedLists {
    std::vector<std::uint32_t> starts;  ///< [list of a slice + 1] [vector]
    LineAligned<std::uint32_t> items;   ///< [vector][lane]
};

/// The springs of a mesh by slices, those of a kind together, each particle's by rising slot.
template <typename Real>
struct MeshSpringTables {
    SlicedLists neighbours;      ///< three lists a slice, by SpringKind
    LineAligned<Real> tensions;  ///< [vector][lane], k L / root_scale [N]
    LineAligned<Real> widths;    ///< [vector][lane]; empty where all are 1

    MeshSpringTables() = default;
    MeshSpringTables(const ClothModel& cloth, std::size_t lanes);
};

/// The triangles of a mesh by rising lowest slot, and every slot's list of them.
struct MeshTriangleTables {
    static constexpr std::uint32_t none = 0xffffffff;  ///< padding in lists

    LineAligned<std::uint32_t> corners;  ///< [vector][corner][lane], slots; padding: all alike
    SlicedLists triangles;               ///< one list a slice

    MeshTriangleTables() = default;
    MeshTriangleTables(const ClothModel& cloth, std::size_t lanes);
};

extern template struct MeshSpringTables<float>;
extern template struct MeshSpringTables<double>;

}  // namespace weft
