// Smoothed aggregation multigrid (Vanek, Mandel and Brezina, Computing 56, 1996) as a
// preconditioner: one visit of the first coarse level, W-cycles from there, with block Jacobi
// sweeps, Galerkin's coarse matrices, and a dense factorisation of the last. The prolongations are
// made once, of weights that do not change, and are the same for all three components: an update
// costs sums of blocks alone.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "math/aggregates.h"
#include "math/conjugate_gradient.h"

namespace weft {

class BlockAggregation final : public BlockPreconditioner {
public:
    /// @param graph the matrix's edges, each pair once, with weights near what its blocks are like.
    /// @param places [edge], where the matrix has an edge's coupling, in either direction.
    BlockAggregation(const RowGraph& graph, std::span<const std::uint32_t> places,
                     InstructionSet set);
    ~BlockAggregation() override;

    void update(BlockMatrix& a) override;
    double apply(const BlockVector& r, BlockVector& z) override;

    /// Rows of the coarse matrices.
    [[nodiscard]] std::vector<std::size_t> coarse_rows() const;

private:
    struct Level;
    struct Coarsest;

    // Each returns b.x.
    double cycle(std::size_t number, const BlockVector& b, BlockVector& x);
    double solve_last(const BlockVector& b, BlockVector& x);
    void correct(std::size_t number, const BlockVector& b);
    void set_weight(Level& level);

    std::vector<std::unique_ptr<Level>> levels_;
    std::unique_ptr<Coarsest> coarsest_;  // nullptr: the last level's sweeps must do
};

}  // namespace weft
