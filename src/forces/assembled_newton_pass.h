// Kernels of Newton's matrix of listed springs (forces/assembled_newton_matrix.h): its couplings
// from positions, and its product in double from positions alone, which leaves only B to be added.
#pragma once

#include <cstddef>
#include <cstdint>

#include "math/block_matrix.h"
#include "math/instruction_sets.h"

namespace weft {

/// What a kernel reads and writes; pointers belong to others and are aligned to cache lines.
struct AssembledPass {
    const std::uint32_t *starts = nullptr, *columns = nullptr;  ///< of a BlockPattern
    /// [vector][lane], of the spring between a row and its column; zero where there is none.
    const double* rest_lengths = nullptr;  ///< L [m]
    const double* stiffnesses = nullptr;   ///< k [N/m]
    const double* dampings = nullptr;      ///< c [N s/m]
    double inverse_tau = 0.0;              ///< [1/s]
    const double* x = nullptr;             ///< [row][4], positions [m]

    float* couplings = nullptr;  ///< of `assemble`: of a BlockMatrix, form spring
    const double* u = nullptr;   ///< of `product`: [row][4]
    double* out = nullptr;       ///< [row][4]
};

/// Runs a kernel over slices [begin, end).
using AssembledFunction = void (*)(const AssembledPass&, std::size_t begin, std::size_t end);

struct AssembledFunctions {
    AssembledFunction assemble;  ///< K + C / tau of every coupling
    AssembledFunction product;   ///< out_i = sum over couplings of (K + C / tau) (u_i - u_j)
};

/// Those compiled for an instruction set; for scalar, plain loops.
AssembledFunctions assembled_functions(InstructionSet set);

}  // namespace weft
