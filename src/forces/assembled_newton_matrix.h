// Solvers of Newton's matrix (forces/newton_matrix.h) for any cloth, grid or mesh, from a sparse
// matrix of 3 x 3 blocks.
#pragma once

#include <memory>
#include <string_view>

#include "cloth/cloth_model.h"
#include "forces/newton_matrix.h"
#include "math/instruction_sets.h"

namespace weft {

/// Solvers by name:
///   "cholesky"     sparse factorisation in double; norms are Euclidean
///   "simplicial cholesky"  the same without CHOLMOD's supernodal module; its name() is "cholesky"
///   "jacobi"       conjugate gradients, preconditioned by the diagonal blocks
///   "aggregation"  the same, by smoothed aggregation multigrid
/// "jacobi" and "aggregation" iterate in float. Below a tolerance of 3e-2, or after more than 100
/// iterations, the residual is taken in double, straight from the springs, and solved for again
/// until it is small enough; else the iteration's own estimate stands. They reach 1e-9 of any but
/// the worst matrices.
/// @param threads not needed: loops run on the threads of whoever calls, with the same results.
/// @return nullptr for other names.
std::unique_ptr<NewtonMatrixSolver> make_assembled_solver(const ClothModel& cloth,
                                                          std::string_view name, InstructionSet set,
                                                          int threads);

}  // namespace weft
