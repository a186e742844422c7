// The coarsest level of a grid's multigrid solver, solved directly. Nodes are numbered along the
// sheet's shorter side, so that even a long strip's matrix has few diagonals.
#pragma once

#include <vector>

#include "forces/grid_multigrid_level.h"
#include "math/banded_cholesky.h"

namespace weft {

class MultigridDirect {
public:
    explicit MultigridDirect(const MultigridLevel& level);

    /// Takes the level's matrix, with the identity for pinned nodes. Uses its u and b.
    void factor(MultigridLevel& level);
    /// Whether the matrix could be factored.
    [[nodiscard]] bool valid() const { return valid_; }

    /// level.u = A^-1 level.b; returns b.u.
    /// @pre valid().
    double solve(MultigridLevel& level);

private:
    // Springs reach two nodes along the longer side.
    static constexpr std::size_t reach = 2, apart = 2 * reach + 1;

    struct Node {
        std::size_t slot = 0;
        std::size_t place = 0;  // of its x component in the system
    };
    void take_columns(const MultigridLevel& level, std::size_t along, std::size_t across,
                      std::size_t component);

    std::size_t length_, width_;  // nodes along the longer and the shorter side
    std::vector<Node> nodes_;     // [along * width + across]
    BandedCholesky matrix_;
    std::vector<double> vector_;
    bool valid_ = false;
};

}  // namespace weft
