// Colours for Gauss-Seidel: what has one colour touches nothing of its own kind, so that a colour
// may run on any number of threads and give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth/spring_network.h"

namespace weft {

/// Springs sorted by colour; two of one colour share no free particle. Springs between two pins are
/// left out. A 12-neighbour grid takes 12 colours, which is the least.
struct ColouredSprings {
    std::vector<SpringNetwork::Spring> springs;
    std::vector<std::size_t> first;  ///< [colour], and the end of the last
    [[nodiscard]] std::size_t colour_count() const { return first.size() - 1; }
};

/// First fit in the network's order: deterministic, at most 2 d - 1 colours for d springs at the
/// busiest particle.
ColouredSprings colour_springs(const SpringNetwork& network);

/// Free particles sorted by colour; no spring joins two of one colour.
struct ColouredParticles {
    std::vector<std::uint32_t> slots;
    std::vector<std::size_t> first;  ///< [colour], and the end of the last
    [[nodiscard]] std::size_t colour_count() const { return first.size() - 1; }
};

/// First fit by rising slot: at most d + 1 colours.
ColouredParticles colour_particles(const SpringNetwork& network);

/// The springs of listed particles, row by row: each spring stands in both its ends' rows.
template <typename Real>
struct SpringRows {
    struct Entry {
        std::uint32_t other = 0;  ///< slot of the spring's other end
        Real rest_length{};       ///< [m]
        Real stiffness{};         ///< [N/m]
        Real damping{};           ///< [N s/m]
    };
    std::vector<std::uint32_t> slots;  ///< [row]
    std::vector<std::uint32_t> first;  ///< [row], and the end of the last
    std::vector<Entry> entries;        ///< in the network's order within a row

    SpringRows() = default;
    SpringRows(const SpringNetwork& network, std::vector<std::uint32_t> particles);
};

/// Slots of the particles that are not pinned, rising.
std::vector<std::uint32_t> free_slots(const SpringNetwork& network);

/// Whether any spring has a dashpot.
bool has_dashpots(const SpringNetwork& network);

extern template struct SpringRows<float>;
extern template struct SpringRows<double>;

}  // namespace weft
