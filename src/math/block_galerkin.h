// Galerkin's coarse matrix P^T A P for a prolongation that does not change: which fine block adds
// to which coarse one, and with what weight, is found once; the blocks are added up whenever the
// values are new.
//
// Fine rows are taken in chunks, each with sums of its own for the few coarse blocks that it
// reaches, so that fine values and weights are read once, in the order in which they stand, and
// the sums stay in the cache. Chunks do not depend on threads; nor does the order in which their
// sums come together.
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
    // A fine block: a coupling of the matrix, or a row's own.
    struct Source {
        std::uint32_t place = 0;  // of a coupling; or the row
        std::uint32_t terms = 0;  // how many
    };
    // What it adds to one of its chunk's sums.
    struct Term {
        std::uint32_t sum = 0;
        float weight = 0.0f;
    };
    struct Chunk {
        std::size_t couplings = 0, rows = 0;  // where its sources begin: couplings, then rows
        std::size_t terms = 0, sums = 0;
    };
    // A coarse block.
    struct Target {
        std::uint32_t row = 0, column = 0;  // the same: the row's own
        std::uint32_t place = 0, mirror = 0;
    };
    class Builder;
    static constexpr std::size_t record_size = 8;  // a block of 6, in whole vectors

    void set_coarse(std::span<const double> weights, const Prolongation& prolongation);
    void add_up(const BlockMatrix& fine, std::size_t chunk);
    // Of sources [begin, end), whose terms begin at `term`. read(place, record) reads a block.
    // Returns where their terms end.
    template <typename ReadBlock>
    const Term* add_sources(std::size_t begin, std::size_t end, const Term* term,
                            const ReadBlock& read);

    std::vector<Chunk> chunks_;  // and where the last ends
    std::vector<Source> sources_;
    std::vector<Term> terms_;
    LineAligned<float> sums_;  // [sum][record_size]
    std::vector<Target> targets_;
    std::vector<std::uint32_t> parts_starts_, parts_;  // [target + 1]; its sums, by chunks
    RowGraph coarse_;
    BlockPattern pattern_;
    std::vector<std::uint32_t> places_;
};

}  // namespace weft
