// Preconditioned conjugate gradients (Hestenes and Stiefel 1952) in float, with the scalars in
// double.
#pragma once

#include <cmath>

#include "math/block_kernel.h"
#include "math/linear_report.h"

namespace weft {

/// An approximate inverse of a matrix, symmetric and positive.
class BlockPreconditioner {
public:
    virtual ~BlockPreconditioner() = default;

    /// Takes a matrix of the pattern that it was made for, with new values. Finds its factors.
    /// The matrix must stay as it is.
    virtual void update(BlockMatrix& a) = 0;
    /// z = M^-1 r
    /// @return r.z
    virtual double apply(const BlockVector& r, BlockVector& z) = 0;
};

class ConjugateGradient {
public:
    ConjugateGradient() = default;
    ConjugateGradient(std::size_t slices, InstructionSet set)
        : kernel_(slices, set), z_(slices, false), p_(slices, true), q_(slices, false) {}

    /// d with |r - A d| <= tolerance |r| as far as float and the recurrence tell.
    /// @param norm |r|, more than zero.
    /// @param r becomes r - A d.
    LinearReport solve(const BlockMatrix& a, BlockPreconditioner& m, double norm, double tolerance,
                       int max_iterations, BlockVector& r, BlockVector& d) {
        d.fill_zero();
        p_.fill_zero();
        LinearReport report{0, 1.0, tolerance >= 1.0};
        double rz = 0.0;
        while (!report.converged && report.iterations < max_iterations) {
            const double next = m.apply(r, z_);
            kernel_.direction(rz > 0.0 ? next / rz : 0.0, z_, p_);
            rz = next;
            const double curvature = kernel_.product(a, p_, q_);
            if (!(rz > 0.0) || !(curvature > 0.0)) break;  // rounding has the last word
            const double square = kernel_.advance(rz / curvature, p_, q_, d, r);
            ++report.iterations;
            report.residual = std::sqrt(square) / norm;
            report.converged = report.residual <= tolerance;
        }
        return report;
    }

private:
    BlockKernel kernel_;
    BlockVector z_, p_, q_;
};

}  // namespace weft
