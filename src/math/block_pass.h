// Kernels of matrices of math/block_matrix.h and their vectors: one pass over rows each. All in
// float; scalar products are summed in float within a block of rows and in double over blocks, in
// order: threads do not change results.
#pragma once

#include <cstddef>
#include <cstdint>

#include "math/block_matrix.h"
#include "math/instruction_sets.h"

namespace weft {

/// Slices whose scalar products are summed together.
inline constexpr std::size_t slices_per_block = 64;

/// What a kernel reads and writes; which of it, the kernel says. Pointers belong to others.
struct BlockPass {
    std::size_t slices = 0;
    BlockForm form = BlockForm::symmetric;
    const std::uint32_t *starts = nullptr, *columns = nullptr;  ///< of a BlockPattern
    const float* couplings = nullptr;
    const float *own = nullptr, *factors = nullptr;
    float *own_out = nullptr, *factors_out = nullptr;  ///< of `factor`

    const float *u = nullptr, *u_records = nullptr;
    const float* b = nullptr;
    float* out = nullptr;
    float* out_records = nullptr;  ///< nullptr: nobody reads them
    float* residual = nullptr;     ///< of `advance`
    float weight = 1.0f;
    double* sums = nullptr;  ///< [block]
};

/// Runs a pass over blocks [begin, end).
using BlockFunction = void (*)(const BlockPass&, std::size_t begin, std::size_t end);

struct BlockFunctions {
    BlockFunction factor;        ///< own += weight trace(A_ii) I; factors
    BlockFunction product;       ///< out = A u; sums: u.out
    BlockFunction residual;      ///< out = b - A u
    BlockFunction smooth;        ///< out = u + weight W^T W (b - A u); sums: b.out
    BlockFunction precondition;  ///< out = weight W^T W b; sums: b.out
    BlockFunction advance;       ///< out += weight u, residual -= weight b; sums: residual^2
    BlockFunction direction;     ///< out = u + weight out
    /// out = u + sum of numbers times records; without u: the sum. `couplings` has one number each.
    BlockFunction transfer;
};

/// Those compiled for an instruction set; for scalar, plain loops.
BlockFunctions block_functions(InstructionSet set);

/// The readable twins.
BlockFunctions plain_block_functions();

}  // namespace weft
