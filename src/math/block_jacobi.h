// The diagonal blocks as a preconditioner.
#pragma once

#include "math/conjugate_gradient.h"

namespace weft {

class BlockJacobi final : public BlockPreconditioner {
public:
    BlockJacobi(std::size_t slices, InstructionSet set) : kernel_(slices, set) {}

    void update(BlockMatrix& a) override {
        kernel_.factor(a);
        matrix_ = &a;
    }
    double apply(const BlockVector& r, BlockVector& z) override {
        return kernel_.precondition(*matrix_, 1.0, r, z);
    }

private:
    BlockKernel kernel_;
    const BlockMatrix* matrix_ = nullptr;
};

}  // namespace weft
