// Newton's matrix of a grid solved by conjugate gradients preconditioned by geometric multigrid:
// one symmetric V-cycle over ever coarser sheets of springs, so that the number of iterations does
// not grow with the grid. Everything is recomputed from positions; no matrix is stored.
//
// A coarser sheet has half as many columns and rows, rest lengths that are as much longer, and
// spring constants that leave the sheet's moduli of stretch and shear as they are; it stands where
// its nodes stand on the finer one. Corrections are interpolated linearly, P, residuals gathered by
// R = P^T. Smoothed by damped block Jacobi, whose weights are the roots of a Chebyshev polynomial
// (Adams, Brezina, Hu, Tuminaro, J. Comput. Phys. 188 (2003) 593), solved on the coarsest sheet.
#pragma once

#include <memory>

#include "cloth/cloth_model.h"
#include "forces/newton_matrix.h"
#include "math/instruction_sets.h"

namespace weft {

/// Solves in float, sums scalar products in double; a tolerance below some 1e-6 is not reached.
/// The norm of LinearReport is the Euclidean one.
/// @param cloth a grid; outlives the solver.
/// @param set scalar: the readable twins of the kernels.
/// @param threads that a solution may be shared by; does not change it.
std::unique_ptr<NewtonMatrixSolver> make_grid_multigrid(const ClothModel& cloth, InstructionSet set,
                                                        int threads);

}  // namespace weft
