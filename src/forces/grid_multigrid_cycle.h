// The V-cycle of a grid's multigrid solver: levels of ever coarser sheets, the coarsest solved
// directly.
#pragma once

#include <vector>

#include "forces/grid_multigrid_direct.h"
#include "forces/grid_multigrid_level.h"

namespace weft {

class MultigridCycle {
public:
    MultigridCycle(const ClothModel& cloth, const NewtonKernels& kernels, int threads);

    /// As NewtonMatrixSolver::linearise(). Afterwards valid() says whether apply() can be used.
    void linearise(ConstVec3View<double> x, double inverse_tau,
                   const SymmetricBlocks<double>& blocks);
    [[nodiscard]] bool valid() const { return direct_.valid(); }

    /// finest().u = C finest().b, an approximate solution of A u = b; returns b.u.
    /// C is symmetric and positive definite: smoothing is the same before and after the coarser
    /// level's correction, and converges, for D^-1 A has no eigenvalue above 2: a spring's energy
    /// is at most twice that of its ends moved one at a time.
    double apply() { return cycle(0); }

    [[nodiscard]] MultigridLevel& finest() { return levels_.front(); }

private:
    double cycle(std::size_t level);

    std::vector<MultigridLevel> levels_;  // finest first
    MultigridDirect direct_;              // of the coarsest
};

}  // namespace weft
