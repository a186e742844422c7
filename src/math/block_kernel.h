// What solvers do with matrices and vectors of math/block_matrix.h, on the threads of the caller's
// team.
#pragma once

#include <vector>

#include "math/block_pass.h"

namespace weft {

/// Kernels for one number of rows. Vectors in and out are of that number, and differ; those read
/// at couplings' columns have records.
class BlockKernel {
public:
    BlockKernel() = default;
    BlockKernel(std::size_t slices, InstructionSet set);

    /// Finds a matrix's factors, B increased by shift trace(A_ii) I before.
    void factor(BlockMatrix& a, double shift = 0.0) const;
    /// out = A u
    /// @return u.out
    double product(const BlockMatrix& a, const BlockVector& u, BlockVector& out);
    /// out = b - A u
    void residual(const BlockMatrix& a, const BlockVector& u, const BlockVector& b,
                  BlockVector& out) const;
    /// out = u + weight D^-1 (b - A u), with D the diagonal blocks: a sweep of block Jacobi.
    /// @return b.out
    double smooth(const BlockMatrix& a, double weight, const BlockVector& u, const BlockVector& b,
                  BlockVector& out);
    /// out = weight D^-1 b
    /// @return b.out
    double precondition(const BlockMatrix& a, double weight, const BlockVector& b,
                        BlockVector& out);
    /// d += weight p, r -= weight q
    /// @return r.r
    double advance(double weight, const BlockVector& p, const BlockVector& q, BlockVector& d,
                   BlockVector& r);
    /// p = z + weight p
    void direction(double weight, const BlockVector& z, BlockVector& p) const;
    /// out = base + sum of weights times what their columns name of `from`; without base: the sum.
    /// @param weights [vector][lane] of the pattern; its rows are the kernel's.
    void transfer(const BlockPattern& pattern, const LineAligned<float>& weights,
                  const BlockVector& from, const BlockVector* base, BlockVector& out) const;

private:
    [[nodiscard]] BlockPass pass_of(const BlockMatrix& a) const;
    void run(BlockFunction function, const BlockPass& pass) const;
    double run_summed(BlockFunction function, BlockPass pass);

    std::size_t slices_ = 0;
    BlockFunctions functions_{};
    std::vector<double> sums_;  // [block]
};

}  // namespace weft
