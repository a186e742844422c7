#include "math/block_kernel.h"

#include "math/parallel.h"

namespace weft {

namespace {

void set_out(BlockPass& pass, BlockVector& out) {
    pass.out = out.values.data();
    pass.out_records = out.records.data();
}

void set_operand(BlockPass& pass, const BlockVector& u) {
    pass.u = u.values.data();
    pass.u_records = u.records.data();
}

}  // namespace

BlockKernel::BlockKernel(std::size_t slices, InstructionSet set)
    : slices_(slices),
      functions_(block_functions(set)),
      sums_((slices + slices_per_block - 1) / slices_per_block) {}

void BlockKernel::run(BlockFunction function, const BlockPass& pass) const {
    constexpr std::size_t grain = 4;  // blocks; below, waking a thread costs more than the loop
    parallel_for(sums_.size(), grain,
                 [&](std::size_t begin, std::size_t end) { function(pass, begin, end); });
}

double BlockKernel::run_summed(BlockFunction function, BlockPass pass) {
    pass.sums = sums_.data();
    run(function, pass);
    double sum = 0.0;
    for (const double block : sums_) sum += block;
    return sum;
}

BlockPass BlockKernel::pass_of(const BlockMatrix& a) const {
    BlockPass pass;
    pass.slices = slices_;
    pass.form = a.form;
    pass.starts = a.pattern->starts();
    pass.columns = a.pattern->columns();
    pass.couplings = a.couplings.data();
    pass.own = a.own.data();
    pass.factors = a.factors.data();
    return pass;
}

void BlockKernel::factor(BlockMatrix& a, double shift) const {
    BlockPass pass = pass_of(a);
    pass.weight = static_cast<float>(shift);
    pass.own_out = a.own.data();
    pass.factors_out = a.factors.data();
    run(functions_.factor, pass);
}

double BlockKernel::product(const BlockMatrix& a, const BlockVector& u, BlockVector& out) {
    BlockPass pass = pass_of(a);
    set_operand(pass, u);
    set_out(pass, out);
    return run_summed(functions_.product, pass);
}

void BlockKernel::residual(const BlockMatrix& a, const BlockVector& u, const BlockVector& b,
                           BlockVector& out) const {
    BlockPass pass = pass_of(a);
    set_operand(pass, u);
    pass.b = b.values.data();
    set_out(pass, out);
    run(functions_.residual, pass);
}

double BlockKernel::smooth(const BlockMatrix& a, double weight, const BlockVector& u,
                           const BlockVector& b, BlockVector& out) {
    BlockPass pass = pass_of(a);
    set_operand(pass, u);
    pass.b = b.values.data();
    pass.weight = static_cast<float>(weight);
    set_out(pass, out);
    return run_summed(functions_.smooth, pass);
}

double BlockKernel::precondition(const BlockMatrix& a, double weight, const BlockVector& b,
                                 BlockVector& out) {
    BlockPass pass = pass_of(a);
    pass.b = b.values.data();
    pass.weight = static_cast<float>(weight);
    set_out(pass, out);
    return run_summed(functions_.precondition, pass);
}

double BlockKernel::advance(double weight, const BlockVector& p, const BlockVector& q,
                            BlockVector& d, BlockVector& r) {
    BlockPass pass;
    pass.slices = slices_;
    pass.u = p.values.data();
    pass.b = q.values.data();
    pass.out = d.values.data();
    pass.residual = r.values.data();
    pass.weight = static_cast<float>(weight);
    return run_summed(functions_.advance, pass);
}

void BlockKernel::direction(double weight, const BlockVector& z, BlockVector& p) const {
    BlockPass pass;
    pass.slices = slices_;
    pass.u = z.values.data();
    pass.weight = static_cast<float>(weight);
    set_out(pass, p);
    run(functions_.direction, pass);
}

void BlockKernel::transfer(const BlockPattern& pattern, const LineAligned<float>& weights,
                           const BlockVector& from, const BlockVector* base,
                           BlockVector& out) const {
    BlockPass pass;
    pass.slices = slices_;
    pass.starts = pattern.starts();
    pass.columns = pattern.columns();
    pass.couplings = weights.data();
    pass.u = base != nullptr ? base->values.data() : nullptr;
    pass.u_records = from.records.data();
    set_out(pass, out);
    run(functions_.transfer, pass);
}

}  // namespace weft
