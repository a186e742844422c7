// Galerkin's coarse matrix P^T A P for a prolongation that does not change: every coarse block is a
// weighted sum of fine ones, found once and summed whenever the values are new.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/aggregates.h"
#include "math/block_matrix.h"

namespace weft {

class BlockGalerkin {
public:
    /// @param edges of the fine matrix, each pair once.
    /// @param places [edge], where the fine matrix has an edge's coupling, in either direction.
    BlockGalerkin(const RowGraph& graph, std::span<const std::uint32_t> places,
                  const Prolongation& prolongation);

    /// The coarse rows: edges, with the weights of the fine ones, and their places.
    [[nodiscard]] const RowGraph& coarse_graph() const { return coarse_; }
    [[nodiscard]] const BlockPattern& coarse_pattern() const { return pattern_; }
    /// [coarse edge], for the next level.
    [[nodiscard]] const std::vector<std::uint32_t>& coarse_places() const { return places_; }

    /// @param coarse of coarse_pattern() and symmetric form; couplings and own blocks are found.
    void compute(const BlockMatrix& fine, BlockMatrix& coarse);

private:
    // What a fine block adds to a coarse one: of an edge below edge_count_, of a row from there.
    struct Term {
        std::uint32_t source = 0;
        float weight = 0.0f;
    };
    struct Target {
        std::uint32_t row = 0, column = 0;  ///< the same: the row's own block
        std::uint32_t place = 0, mirror = 0;
    };
    struct Contribution;
    static constexpr std::size_t record_size = 8;  ///< a block of 6, in whole vectors

    std::vector<Contribution> contributions(const RowGraph& graph, const Prolongation& p) const;
    static std::vector<Contribution> by_target(const std::vector<Contribution>& all,
                                               std::size_t rows);
    void set_targets(const std::vector<Contribution>& sorted);
    void set_coarse(const RowGraph& graph, const Prolongation& prolongation);
    void read_sources(const BlockMatrix& fine);

    std::size_t edge_count_ = 0;
    std::vector<std::uint32_t> source_places_;  // [edge]
    LineAligned<float> sources_;                // [edges, then rows][record_size]
    std::vector<Target> targets_;
    std::vector<std::uint32_t> starts_;  // [target + 1]
    std::vector<Term> terms_;
    RowGraph coarse_;
    BlockPattern pattern_;
    std::vector<std::uint32_t> places_;
};

}  // namespace weft
