// Newton's matrix of an implicit stage,
//     A = B + sum over springs of (K_s + C_s / tau),
// and what solves A d = r. B is block diagonal: masses over tau^2, drag and air over tau. Springs
// give, with n = d / l between their ends,
//     K_s = k (n n^T + max(0, 1 - L/l) (I - n n^T)),   C_s = c n n^T,
// so that A is symmetric and positive definite: the negative part of a compressed spring's Hessian
// is left out, and so is what dashpots and air change by when the cloth turns.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "math/linear_report.h"
#include "math/vec3_array.h"

namespace weft {

/// Symmetric 3 x 3 blocks, one a slot: [xx, xy, xz, yy, yz, zz][slot].
template <typename Real>
struct SymmetricBlocks {
    std::array<std::vector<Real>, 6> entries;

    SymmetricBlocks() = default;
    explicit SymmetricBlocks(std::size_t slots) {
        for (std::vector<Real>& entry : entries) entry.assign(slots, Real{0});
    }
};

/// Solves with Newton's matrix of one cloth, in arrays by slot. Pinned particles and padding do
/// not take part: what r says there is not read, and d is zero there.
class NewtonMatrixSolver {
public:
    virtual ~NewtonMatrixSolver() = default;

    /// Takes the matrix at positions x. Both arguments must stay as they are until the next call.
    /// @param inverse_tau 1 / tau, the weight of dashpots [1/s]; 0: without them.
    /// @param blocks B [kg/s2], positive definite where particles are free.
    virtual void linearise(ConstVec3View<double> x, double inverse_tau,
                           const SymmetricBlocks<double>& blocks) = 0;

    /// d with |r - A d| <= tolerance |r|, or as near as max_iterations lead. Not converged: d is
    /// the best so far, or zero where the matrix could not be factored.
    virtual LinearReport solve(ConstVec3View<double> r, double tolerance, int max_iterations,
                               Vec3View<double> d) = 0;

    /// As `integrator.linear_solver` names it: "multigrid", "cholesky", "jacobi", "aggregation".
    [[nodiscard]] virtual std::string_view name() const = 0;
};

}  // namespace weft
