#include "forces/assembled_newton_matrix.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "forces/assembled_springs.h"
#include "math/block_aggregation.h"
#include "math/block_cholesky.h"
#include "math/block_jacobi.h"
#include "math/conjugate_gradient.h"
#include "math/parallel.h"

namespace weft {

namespace {

AssembledSprings springs_of(const ClothModel& cloth, InstructionSet set) {
    std::vector<Vec3d> places(cloth.layout.slot_count());
    cloth.layout.for_each(
        [&](std::size_t p, std::size_t slot) { places[slot] = cloth.rest_position(p); });
    return AssembledSprings(spring_network(cloth), std::move(places), set);
}

void set_zero(Vec3View<double> d) {
    for (double* const c : {d.x, d.y, d.z}) std::fill_n(c, d.size, 0.0);
}

// Conjugate gradients in float within refinement in double.
class IteratedNewtonMatrix final : public NewtonMatrixSolver {
public:
    using MakePreconditioner =
        std::function<std::unique_ptr<BlockPreconditioner>(const AssembledSprings&)>;

    IteratedNewtonMatrix(std::string name, AssembledSprings springs, InstructionSet set,
                         const MakePreconditioner& make)
        : name_(std::move(name)),
          springs_(std::move(springs)),
          matrix_(springs_.pattern(), BlockForm::spring),
          preconditioner_(make(springs_)),
          iteration_(springs_.pattern().slices(), set),
          right_(springs_.pattern().slices(), false),
          step_(springs_.pattern().slices(), false),
          left_(springs_.graph().rows()) {}

    void linearise(ConstVec3View<double> x, double inverse_tau,
                   const SymmetricBlocks<double>& blocks) override {
        springs_.linearise(x, inverse_tau, blocks);
        springs_.assemble(matrix_);
        preconditioner_->update(matrix_);
    }

    LinearReport solve(ConstVec3View<double> r, double tolerance, int max_iterations,
                       Vec3View<double> d) override;

    [[nodiscard]] std::string_view name() const override { return name_; }

private:
    // Down to which tolerance, and up to how many iterations, the recurrence in float is trusted.
    static constexpr double unchecked = 3e-2;
    static constexpr int unchecked_iterations = 100;
    static constexpr double least_step = 1e-4;  // what one solution in float is asked for

    void set_right_side(double scale);
    void add_step(double scale, Vec3View<double> d) const;

    std::string name_;
    AssembledSprings springs_;
    BlockMatrix matrix_;
    std::unique_ptr<BlockPreconditioner> preconditioner_;
    ConjugateGradient iteration_;
    BlockVector right_, step_;
    Vec3Array<double> left_;  // r - A d
};

constexpr std::size_t slot_grain = 4096;

// The residual as floats near 1, whatever its unit.
void IteratedNewtonMatrix::set_right_side(double scale) {
    const ConstVec3View<double> left = std::as_const(left_).view();
    parallel_for(left.size, slot_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s) right_.set(s, scale * left[s]);
    });
}

void IteratedNewtonMatrix::add_step(double scale, Vec3View<double> d) const {
    parallel_for(d.size, slot_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s) d.add(s, scale * step_[s]);
    });
}

LinearReport IteratedNewtonMatrix::solve(ConstVec3View<double> r, double tolerance,
                                         int max_iterations, Vec3View<double> d) {
    set_zero(d);
    const double norm = springs_.masked(r, left_.view());
    if (norm == 0.0) return {0, 0.0, true};
    LinearReport report{0, 1.0, tolerance >= 1.0};
    if (!std::isfinite(norm)) return {0, 1.0, false};
    while (!report.converged && report.iterations < max_iterations) {
        const double size = report.residual * norm;
        set_right_side(1 / size);
        const double wanted = std::max(tolerance / report.residual, least_step);
        const LinearReport inner =
            iteration_.solve(matrix_, *preconditioner_, 1.0, wanted,
                             max_iterations - report.iterations, right_, step_);
        report.iterations += inner.iterations;
        add_step(size, d);
        const double before = report.residual;
        double residual = inner.residual * before;
        const bool trusted = tolerance >= unchecked && inner.iterations <= unchecked_iterations;
        if (!trusted) residual = springs_.residual(r, d, left_.view()) / norm;
        if (residual < before) {
            report.residual = residual;
            report.converged = residual <= tolerance;
        } else {
            add_step(-size, d);
        }
        // One step is all where float is trusted; elsewhere, until float leads no further.
        if (trusted || !(residual < 0.5 * before)) break;
    }
    return report;
}

// Sparse factorisation in double.
class CholeskyNewtonMatrix final : public NewtonMatrixSolver {
public:
    CholeskyNewtonMatrix(AssembledSprings springs, const SpringNetwork& network,
                         BlockCholesky::Modules modules)
        : springs_(std::move(springs)), left_(springs_.graph().rows()) {
        const RowGraph& graph = springs_.graph();
        for (std::size_t s = 0; s < graph.rows(); ++s) {
            row_of_.push_back(static_cast<std::uint32_t>(slots_.size()));
            if (springs_.is_free(s)) slots_.push_back(static_cast<std::uint32_t>(s));
        }
        std::vector<Coupling> couplings;
        for (const SpringNetwork::Spring& s : network.springs) {
            if (s.p == s.q || !(springs_.is_free(s.p) || springs_.is_free(s.q))) continue;
            list_.push_back(s);
            if (springs_.is_free(s.p) && springs_.is_free(s.q)) {
                couplings.push_back({row_of_[s.p], row_of_[s.q]});
            }
        }
        factorisation_ = std::make_unique<BlockCholesky>(slots_.size(), couplings, modules);
        right_.resize(3 * slots_.size());
        solution_.resize(3 * slots_.size());
    }

    void linearise(ConstVec3View<double> x, double inverse_tau,
                   const SymmetricBlocks<double>& blocks) override;
    LinearReport solve(ConstVec3View<double> r, double tolerance, int max_iterations,
                       Vec3View<double> d) override;
    [[nodiscard]] std::string_view name() const override { return "cholesky"; }

private:
    static constexpr int most_corrections = 3;

    AssembledSprings springs_;
    std::vector<SpringNetwork::Spring> list_;  // those with a free end
    std::vector<std::uint32_t> row_of_;        // [slot]
    std::vector<std::uint32_t> slots_;         // [row]
    std::unique_ptr<BlockCholesky> factorisation_;
    bool factored_ = false;
    std::vector<double> right_, solution_;  // [3 row + component]
    Vec3Array<double> left_;
};

// (k (n n^T + t (I - n n^T)) + c / tau n n^T), t = max(0, 1 - L/l).
SymmetricBlock coupling_of(const SpringNetwork::Spring& spring, Vec3d d, double inverse_tau) {
    const double l = length(d);
    if (!(l > 0.0)) return {};
    const double across = spring.stiffness * std::max(0.0, 1 - spring.rest_length / l);
    const double along = spring.stiffness - across + spring.damping * inverse_tau;
    const Vec3d n = d / l;
    return {along * n.x * n.x + across, along * n.x * n.y, along * n.x * n.z,
            along * n.y * n.y + across, along * n.y * n.z, along * n.z * n.z + across};
}

void CholeskyNewtonMatrix::linearise(ConstVec3View<double> x, double inverse_tau,
                                     const SymmetricBlocks<double>& blocks) {
    springs_.linearise(x, inverse_tau, blocks);
    factorisation_->clear();
    for (std::size_t row = 0; row < slots_.size(); ++row) {
        const auto& [xx, xy, xz, yy, yz, zz] = blocks.entries;
        const std::size_t s = slots_[row];
        factorisation_->add_own(row, {xx[s], xy[s], xz[s], yy[s], yz[s], zz[s]});
    }
    std::size_t c = 0;
    for (const SpringNetwork::Spring& spring : list_) {
        const SymmetricBlock k = coupling_of(spring, x[spring.q] - x[spring.p], inverse_tau);
        if (springs_.is_free(spring.p) && springs_.is_free(spring.q)) {
            factorisation_->add_coupling(c++, k);
        } else {
            factorisation_->add_own(row_of_[springs_.is_free(spring.p) ? spring.p : spring.q], k);
        }
    }
    factored_ = factorisation_->factor();
}

LinearReport CholeskyNewtonMatrix::solve(ConstVec3View<double> r, double tolerance,
                                         int /*max_iterations*/, Vec3View<double> d) {
    set_zero(d);
    const double norm = springs_.masked(r, left_.view());
    if (norm == 0.0) return {0, 0.0, true};
    if (!factored_ || !std::isfinite(norm)) return {0, 1.0, false};
    LinearReport report{1, 1.0, false};
    for (int n = 0; n <= most_corrections && !report.converged; ++n) {
        for (std::size_t row = 0; row < slots_.size(); ++row) {
            const Vec3d left = left_[slots_[row]];
            right_[3 * row] = left.x, right_[3 * row + 1] = left.y, right_[3 * row + 2] = left.z;
        }
        factorisation_->solve(right_, solution_);
        for (std::size_t row = 0; row < slots_.size(); ++row) {
            d.add(slots_[row],
                  {solution_[3 * row], solution_[3 * row + 1], solution_[3 * row + 2]});
        }
        report.residual = springs_.residual(r, d, left_.view()) / norm;
        report.converged = report.residual <= tolerance;
    }
    return report;
}

}  // namespace

std::unique_ptr<NewtonMatrixSolver> make_assembled_solver(const ClothModel& cloth,
                                                          std::string_view name, InstructionSet set,
                                                          int /*threads*/) {
    if (name == "cholesky" || name == "simplicial cholesky") {
        return std::make_unique<CholeskyNewtonMatrix>(
            springs_of(cloth, set), spring_network(cloth),
            name == "cholesky" ? BlockCholesky::Modules::all : BlockCholesky::Modules::simplicial);
    }
    IteratedNewtonMatrix::MakePreconditioner make;
    if (name == "jacobi") {
        make = [&](const AssembledSprings& springs) {
            return std::make_unique<BlockJacobi>(springs.pattern().slices(), set);
        };
    } else if (name == "aggregation") {
        make = [&](const AssembledSprings& springs) {
            return std::make_unique<BlockAggregation>(springs.graph(), springs.edge_places(), set);
        };
    } else {
        return nullptr;
    }
    return std::make_unique<IteratedNewtonMatrix>(std::string(name), springs_of(cloth, set), set,
                                                  make);
}

}  // namespace weft
