#include "math/block_aggregation.h"

#include <Eigen/Dense>
#include <cmath>
#include <utility>

#include "math/block_galerkin.h"
#include "math/random.h"

namespace weft {

namespace {

// Of what joins a row to all others. A cloth's diagonals, half as stiff as its structure, have a
// twelfth; its bend springs of a tenth a sixtieth, and are left out: reaching two cells, they would
// make aggregates that sweeps cannot smooth.
constexpr double least_strength = 0.04;
constexpr std::size_t most_dense_rows = 40;
constexpr std::size_t most_levels = 20;

// What is left of the error by the hierarchy below the first coarse level grows with its depth, and
// costs little to mend: nine rows of the finest stand for one. So coarse levels have two sweeps on
// either side and two visits of the next (a W-cycle), the finest one.
constexpr int coarse_sweeps = 2;

// P and its transpose as passes read them.
struct Transfer {
    BlockPattern pattern;
    LineAligned<float> weights;

    Transfer() = default;
    Transfer(const Prolongation& p, std::size_t fine_rows, bool transposed) {
        std::vector<Coupling> couplings;
        for (std::size_t row = 0; row < fine_rows; ++row) {
            const auto fine = static_cast<std::uint32_t>(row);
            for (std::size_t n = p.starts[row]; n < p.starts[row + 1]; ++n) {
                couplings.push_back(transposed ? Coupling{p.columns[n], fine}
                                               : Coupling{fine, p.columns[n]});
            }
        }
        pattern = transposed ? BlockPattern(p.coarse_rows, fine_rows, couplings)
                             : BlockPattern(fine_rows, p.coarse_rows, couplings);
        weights = LineAligned<float>(block_lanes * pattern.vectors());
        for (std::size_t n = 0; n < couplings.size(); ++n) {
            weights[pattern.place(n)] = static_cast<float>(p.weights[n]);
        }
    }
};

}  // namespace

struct BlockAggregation::Level {
    BlockKernel kernel;
    BlockMatrix own_matrix;  // of coarse levels
    BlockMatrix* matrix = nullptr;
    double weight = 2.0 / 3.0;  // of a sweep
    BlockVector x, y, r, b;

    // x becomes what a sweep makes of it.
    void sweep(const BlockVector& right) {
        kernel.smooth(*matrix, weight, x, right, y);
        std::swap(x, y);
    }

    // To the next level; not of the last.
    std::unique_ptr<BlockGalerkin> galerkin;
    Transfer prolong, restrict_;

    Level(std::size_t slices, InstructionSet set)
        : kernel(slices, set),
          x(slices, true),
          y(slices, true),
          r(slices, true),
          b(slices, false) {}
};

// The last level's matrix, factored.
struct BlockAggregation::Coarsest {
    Eigen::MatrixXd matrix;
    Eigen::LLT<Eigen::MatrixXd> factor;
    Eigen::VectorXd solution;

    explicit Coarsest(std::size_t rows)
        : matrix(3 * rows, 3 * rows),
          factor(static_cast<Eigen::Index>(3 * rows)),
          solution(3 * rows) {}

    void update(const BlockMatrix& a);
    double solve(const BlockVector& b, BlockVector& x);
};

void BlockAggregation::Coarsest::update(const BlockMatrix& a) {
    matrix.setZero();
    const BlockPattern& pattern = *a.pattern;
    const auto add = [&](std::size_t row, std::size_t column, double sign, SymmetricBlock s) {
        Eigen::Matrix3d block;
        block << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
        matrix.block<3, 3>(static_cast<Eigen::Index>(3 * row),
                           static_cast<Eigen::Index>(3 * column)) += sign * block;
    };
    for (std::size_t row = 0; row < pattern.rows(); ++row) add(row, row, 1.0, a.own_block(row));
    for (std::size_t slice = 0; slice < pattern.slices(); ++slice) {
        for (std::size_t n = block_lanes * pattern.starts()[slice];
             n < block_lanes * pattern.starts()[slice + 1]; ++n) {
            const std::size_t row = slice * block_lanes + n % block_lanes;
            const std::size_t column = pattern.columns()[n] / 4;
            if (column == row) continue;
            add(row, row, 1.0, a.coupling(n));
            add(row, column, -1.0, a.coupling(n));
        }
    }
    factor.compute(matrix);
}

double BlockAggregation::Coarsest::solve(const BlockVector& b, BlockVector& x) {
    const std::size_t rows = static_cast<std::size_t>(solution.size()) / 3;
    for (std::size_t row = 0; row < rows; ++row) {
        const Vec3d v = b[row];
        solution.segment<3>(static_cast<Eigen::Index>(3 * row)) << v.x, v.y, v.z;
    }
    factor.solveInPlace(solution);
    double sum = 0.0;
    for (std::size_t row = 0; row < rows; ++row) {
        const auto at = static_cast<Eigen::Index>(3 * row);
        const Vec3d v{solution[at], solution[at + 1], solution[at + 2]};
        x.set(row, v);
        sum += dot(b[row], v);
    }
    return sum;
}

BlockAggregation::BlockAggregation(const RowGraph& graph, std::span<const std::uint32_t> places,
                                   InstructionSet set) {
    const auto slices_of = [](std::size_t rows) { return (rows + block_lanes - 1) / block_lanes; };
    levels_.push_back(std::make_unique<Level>(slices_of(graph.rows()), set));
    const RowGraph* fine = &graph;
    std::size_t rows = graph.rows();
    while (rows > most_dense_rows && levels_.size() < most_levels) {
        const Prolongation p = prolongation_of(*fine, least_strength);
        if (p.coarse_rows == 0 || 3 * p.coarse_rows > 2 * rows) break;
        Level& level = *levels_.back();
        level.prolong = Transfer(p, fine->rows(), false);
        level.restrict_ = Transfer(p, fine->rows(), true);
        level.galerkin = std::make_unique<BlockGalerkin>(*fine, places, p);
        fine = &level.galerkin->coarse_graph();
        places = level.galerkin->coarse_places();
        rows = p.coarse_rows;
        levels_.push_back(std::make_unique<Level>(slices_of(rows), set));
        Level& coarse = *levels_.back();
        coarse.own_matrix = BlockMatrix(level.galerkin->coarse_pattern(), BlockForm::symmetric);
        coarse.matrix = &coarse.own_matrix;
    }
    if (rows <= most_dense_rows && levels_.size() > 1) {
        coarsest_ = std::make_unique<Coarsest>(rows);
    }
}

BlockAggregation::~BlockAggregation() = default;

std::vector<std::size_t> BlockAggregation::coarse_rows() const {
    std::vector<std::size_t> rows;
    for (std::size_t l = 1; l < levels_.size(); ++l) {
        rows.push_back(levels_[l]->own_matrix.pattern->rows());
    }
    return rows;
}

void BlockAggregation::update(BlockMatrix& a) {
    levels_.front()->matrix = &a;
    levels_.front()->kernel.factor(a);
    for (std::size_t l = 1; l < levels_.size(); ++l) {
        Level& level = *levels_[l];
        levels_[l - 1]->galerkin->compute(*levels_[l - 1]->matrix, level.own_matrix);
        // What rounding may take from a coarse block, given back: it must not become negative.
        constexpr double rounding = 1e-6;
        level.kernel.factor(level.own_matrix, rounding);
        set_weight(level);
    }
    if (coarsest_) coarsest_->update(levels_.back()->own_matrix);
}

// 4/3 over the largest eigenvalue of D^-1 A, by power iterations on a fixed vector: what they lack
// of it, the fraction leaves room for. (The finest matrix, of springs, has at most 2.)
void BlockAggregation::set_weight(Level& level) {
    constexpr int iterations = 6;
    for (std::size_t row = 0; row < level.own_matrix.pattern->rows(); ++row) {
        const auto component = [&](std::uint64_t c) { return random_uniform(7, c, row) - 0.5; };
        level.x.set(row, {component(0), component(1), component(2)});
    }
    double largest = 2.0;
    for (int n = 0; n < iterations; ++n) {
        const double square = level.kernel.product(*level.matrix, level.x, level.r);
        const double scale = square > 0.0 ? 1 / std::sqrt(square) : 0.0;
        largest = scale * scale * level.kernel.precondition(*level.matrix, 1.0, level.r, level.y);
        level.kernel.precondition(*level.matrix, scale, level.r, level.x);
    }
    level.weight = largest > 0.0 ? 4.0 / 3.0 / largest : 2.0 / 3.0;
}

double BlockAggregation::solve_last(const BlockVector& b, BlockVector& x) {
    if (coarsest_) return coarsest_->solve(b, x);
    Level& level = *levels_.back();
    level.kernel.precondition(*level.matrix, level.weight, b, level.x);
    return level.kernel.smooth(*level.matrix, level.weight, level.x, b, x);
}

// x += P C P^T (b - A x), with C the next level's cycle.
void BlockAggregation::correct(std::size_t number, const BlockVector& b) {
    Level& level = *levels_[number];
    Level& coarse = *levels_[number + 1];
    level.kernel.residual(*level.matrix, level.x, b, level.r);
    coarse.kernel.transfer(level.restrict_.pattern, level.restrict_.weights, level.r, nullptr,
                           coarse.b);
    BlockVector& solution = coarse.r;  // free again where that cycle ends
    cycle(number + 1, coarse.b, solution);
    level.kernel.transfer(level.prolong.pattern, level.prolong.weights, solution, &level.x,
                          level.y);
    std::swap(level.x, level.y);
}

// Read from its end it is the same, and each part is symmetric: so is the whole, as conjugate
// gradients need it.
double BlockAggregation::cycle(std::size_t number, const BlockVector& b, BlockVector& x) {
    if (number + 1 == levels_.size()) return solve_last(b, x);
    Level& level = *levels_[number];
    const int sweeps = number == 0 ? 1 : coarse_sweeps;
    level.kernel.precondition(*level.matrix, level.weight, b, level.x);
    for (int n = 1; n < sweeps; ++n) level.sweep(b);
    correct(number, b);
    if (number > 0 && number + 2 < levels_.size()) {  // once where the next is the last
        level.sweep(b);
        correct(number, b);
    }
    for (int n = 1; n < sweeps; ++n) level.sweep(b);
    return level.kernel.smooth(*level.matrix, level.weight, level.x, b, x);
}

double BlockAggregation::apply(const BlockVector& r, BlockVector& z) {
    return cycle(0, r, z);
}

}  // namespace weft
