// Solvers of block matrices against dense factorisations.
#include <gtest/gtest.h>

#include <array>

#include "math/block_aggregation.h"
#include "math/block_cholesky.h"
#include "math/block_galerkin.h"
#include "math/block_jacobi.h"
#include "support/block_examples.h"

namespace weft::test {
namespace {

// Iterations to a residual of 1e-4 and the error of the solution, relative.
struct Outcome {
    LinearReport report;
    double error = 0.0;
};

Outcome solve(BlockExample& e, BlockPreconditioner& preconditioner, InstructionSet set) {
    const std::size_t slices = e.pattern.slices(), rows = e.graph.rows();
    preconditioner.update(e.matrix);
    BlockVector r = random_block_vector(e.graph, slices, 9), d(slices, false);
    const Eigen::VectorXd right = as_dense(r, rows);
    ConjugateGradient iteration(slices, set);
    Outcome outcome;
    outcome.report = iteration.solve(e.matrix, preconditioner, right.norm(), 1e-4, 1000, r, d);
    const Eigen::VectorXd solution = e.dense().ldlt().solve(right);
    outcome.error = (as_dense(d, rows) - solution).norm() / solution.norm();
    return outcome;
}

TEST(ConjugateGradient, SolvesAsADenseFactorisationDoes) {
    for (const BlockForm form : {BlockForm::spring, BlockForm::symmetric}) {
        for (const bool held : {false, true}) {
            for (std::size_t n = 0; n < instruction_sets().size(); ++n) {
                const auto set = static_cast<InstructionSet>(n);
                BlockExample e(19, 14, form, held);
                BlockJacobi jacobi(e.pattern.slices(), set);
                const Outcome by_jacobi = solve(e, jacobi, set);
                EXPECT_TRUE(by_jacobi.report.converged);
                EXPECT_LT(by_jacobi.report.residual, 1e-4);
                EXPECT_LT(by_jacobi.error, 1e-3);
                BlockAggregation aggregation(e.graph, e.places, set);
                const Outcome by_aggregation = solve(e, aggregation, set);
                EXPECT_TRUE(by_aggregation.report.converged);
                EXPECT_LT(by_aggregation.error, 1e-3);
            }
        }
    }
}

TEST(ConjugateGradient, SaysWhereItStopped) {
    BlockExample e(30, 30, BlockForm::spring, false, 1e-4);
    BlockJacobi jacobi(e.pattern.slices(), InstructionSet::scalar);
    jacobi.update(e.matrix);
    BlockVector r = random_block_vector(e.graph, e.pattern.slices(), 9), d(e.pattern.slices(), 0);
    const double norm = as_dense(r, e.graph.rows()).norm();
    ConjugateGradient iteration(e.pattern.slices(), InstructionSet::scalar);
    const LinearReport report = iteration.solve(e.matrix, jacobi, norm, 1e-5, 3, r, d);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.iterations, 3);
    EXPECT_NEAR(report.residual, as_dense(r, e.graph.rows()).norm() / norm, 1e-6);
}

// Sheets without anything that holds them but a little mass: what Jacobi takes grows with the
// sheet's width, what aggregation takes does not.
TEST(BlockAggregation, NeedsNoMoreIterationsOnLargerMatrices) {
    std::vector<int> by_jacobi, by_aggregation;
    for (const std::size_t size : {16u, 32u, 64u, 128u}) {
        BlockExample e(size, size, BlockForm::spring, false, 1e-4);
        for (std::size_t row = 0; row < e.graph.rows(); ++row) {
            e.matrix.set_own(row, {1e-4, 0.0, 0.0, 1e-4, 0.0, 1e-4});
        }
        const InstructionSet set = chosen_instruction_set();
        BlockVector r = random_block_vector(e.graph, e.pattern.slices(), 9);
        BlockVector d(e.pattern.slices(), false);
        const double norm = as_dense(r, e.graph.rows()).norm();
        ConjugateGradient iteration(e.pattern.slices(), set);
        BlockVector right = random_block_vector(e.graph, e.pattern.slices(), 9);
        BlockJacobi jacobi(e.pattern.slices(), set);
        jacobi.update(e.matrix);
        by_jacobi.push_back(iteration.solve(e.matrix, jacobi, norm, 1e-4, 2000, r, d).iterations);
        BlockAggregation aggregation(e.graph, e.places, set);
        aggregation.update(e.matrix);
        by_aggregation.push_back(
            iteration.solve(e.matrix, aggregation, norm, 1e-4, 2000, right, d).iterations);
    }
    EXPECT_LE(by_aggregation.back(), 12);  // 13 where coarse levels are visited once
    EXPECT_LE(by_aggregation[3], by_aggregation[1] + 1);
    EXPECT_GT(by_jacobi[3], 3 * by_aggregation[3]);
}

// Of four levels and more, so that coarse ones are visited twice.
TEST(BlockAggregation, IsSymmetricAndPositive) {
    for (const bool held : {false, true}) {
        for (std::size_t n = 0; n < instruction_sets().size(); ++n) {
            BlockExample e(64, 80, BlockForm::spring, held, 1e-3);
            BlockAggregation aggregation(e.graph, e.places, static_cast<InstructionSet>(n));
            ASSERT_GE(aggregation.coarse_rows().size(), 3u);
            aggregation.update(e.matrix);
            const std::size_t slices = e.pattern.slices(), rows = e.graph.rows();
            std::vector<Eigen::VectorXd> right, solved;
            for (const std::uint64_t seed : {9u, 10u, 11u}) {
                const BlockVector r = random_block_vector(e.graph, slices, seed);
                BlockVector z(slices, false);
                const double product = aggregation.apply(r, z);
                right.push_back(as_dense(r, rows));
                solved.push_back(as_dense(z, rows));
                EXPECT_GT(product, 0.0);
                EXPECT_NEAR(product, right.back().dot(solved.back()), 1e-4 * product);
            }
            for (std::size_t a = 0; a < right.size(); ++a) {
                const std::size_t b = (a + 1) % right.size();
                EXPECT_NEAR(right[a].dot(solved[b]), right[b].dot(solved[a]),
                            1e-5 * right[a].norm() * solved[b].norm());
            }
        }
    }
}

TEST(BlockAggregation, CoarsensByAboutNine) {
    BlockExample e(64, 64, BlockForm::spring, false);
    const std::vector<std::size_t> rows =
        BlockAggregation(e.graph, e.places, InstructionSet::scalar).coarse_rows();
    ASSERT_GE(rows.size(), 2u);
    EXPECT_LT(rows[0], 64u * 64u / 5);
    EXPECT_GT(rows[0], 64u * 64u / 16);
    EXPECT_LE(rows.back(), 40u);
}

// Springs that lead nowhere, and rows on their own.
TEST(BlockAggregation, DoesWithoutCoarseRows) {
    BlockExample alone(50, 1, BlockForm::spring, false);
    alone.graph.edges.clear();
    alone.places.clear();
    BlockMatrix empty(alone.pattern, BlockForm::spring);
    BlockAggregation none(alone.graph, alone.places, InstructionSet::scalar);
    EXPECT_TRUE(none.coarse_rows().empty());
    BlockExample pair(2, 1, BlockForm::spring, false);
    BlockAggregation two(pair.graph, pair.places, InstructionSet::scalar);
    const Outcome outcome = solve(pair, two, InstructionSet::scalar);
    EXPECT_TRUE(outcome.report.converged);
    EXPECT_LT(outcome.error, 1e-3);
}

TEST(Prolongation, ReproducesPlacesInside) {
    const BlockExample e(30, 30, BlockForm::spring, false);
    const Prolongation p = prolongation_of(e.graph, 0.04);
    int near = 0;
    for (std::size_t row = 0; row < e.graph.rows(); ++row) {
        double sum = 0.0;
        Vec3d place{};
        for (std::size_t n = p.starts[row]; n < p.starts[row + 1]; ++n) {
            sum += p.weights[n];
            place += p.weights[n] * p.places[p.columns[n]];
        }
        EXPECT_NEAR(sum, 1.0, 1e-12);  // nothing is held: constants come out
        near += length(place - e.graph.places[row]) < 0.5;
    }
    EXPECT_GT(near, 700);  // of 900, and 450 with weights as smoothing leaves them
}

TEST(Prolongation, LeavesHeldRowsOut) {
    const BlockExample e(30, 30, BlockForm::spring, true);
    const Prolongation p = prolongation_of(e.graph, 0.04);
    for (std::size_t row = 0; row < e.graph.rows(); ++row) {
        double sum = 0.0;
        for (std::size_t n = p.starts[row]; n < p.starts[row + 1]; ++n) sum += p.weights[n];
        EXPECT_LT(sum, 1.0 + 1e-12);
        const bool empty = p.starts[row] == p.starts[row + 1];
        EXPECT_TRUE(empty || e.graph.takes_part[row] != 0);
    }
}

TEST(BlockGalerkin, IsTheTripleProduct) {
    for (const BlockForm form : {BlockForm::spring, BlockForm::symmetric}) {
        const BlockExample e(13, 11, form);
        const Prolongation p = prolongation_of(e.graph, 0.04);
        BlockGalerkin galerkin(e.graph, e.places, p);
        BlockMatrix coarse(galerkin.coarse_pattern(), BlockForm::symmetric);
        galerkin.compute(e.matrix, coarse);
        Eigen::MatrixXd prolong =
            Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * e.graph.rows()),
                                  static_cast<Eigen::Index>(3 * p.coarse_rows));
        for (std::size_t row = 0; row < e.graph.rows(); ++row) {
            for (std::size_t n = p.starts[row]; n < p.starts[row + 1]; ++n) {
                for (std::size_t c = 0; c < 3; ++c) {
                    prolong(static_cast<Eigen::Index>(3 * row + c),
                            static_cast<Eigen::Index>(3 * p.columns[n] + c)) = p.weights[n];
                }
            }
        }
        const Eigen::MatrixXd expected = prolong.transpose() * e.dense() * prolong;
        const auto size = static_cast<std::size_t>(expected.rows()) / 3;
        BlockKernel kernel(galerkin.coarse_pattern().slices(), InstructionSet::scalar);
        BlockVector u(galerkin.coarse_pattern().slices(), true),
            out = BlockVector(u.values.size() / 3 / block_lanes, false);
        for (std::size_t row = 0; row < size; ++row) u.set(row, random_direction(3, 4, row));
        kernel.product(coarse, u, out);
        const Eigen::VectorXd product = expected * as_dense(u, size);
        EXPECT_LT((as_dense(out, size) - product).norm(), 3e-6 * product.norm());
    }
}

// Rows of several chunks, and edges between them: a chain that comes back to where it began.
TEST(BlockGalerkin, AddsUpAcrossChunks) {
    using Numbers = std::array<double, 6>;
    const Numbers joint{1.5, 0.0, 2.0, 0.5, 0.0, 4.5};
    constexpr std::uint32_t rows = 10000;
    RowGraph graph;
    std::vector<Coupling> couplings;
    for (std::uint32_t row = 0; row < rows; ++row) {
        graph.takes_part.push_back(1);
        graph.places.push_back({static_cast<double>(row), 0.0, 0.0});
        graph.edges.push_back({row, (row + 1) % rows, 1.0});
        couplings.push_back({row, (row + 1) % rows});
        couplings.push_back({(row + 1) % rows, row});
    }
    const BlockPattern pattern(rows, couplings);
    BlockMatrix fine(pattern, BlockForm::spring);
    std::vector<std::uint32_t> places;
    for (std::size_t c = 0; c < couplings.size(); ++c) {
        fine.set_spring(pattern.place(c), 0.5, {1.0, 0.0, 2.0});
        if (c % 2 == 0) places.push_back(static_cast<std::uint32_t>(pattern.place(c)));
    }
    for (std::size_t row = 0; row < rows; ++row) fine.set_own(row, {3.0, 0.0, 0.0, 1.0, 0.0, 2.0});
    Prolongation p;  // pairs of rows
    p.coarse_rows = rows / 2;
    for (std::uint32_t row = 0; row < rows; ++row) {
        p.starts.push_back(row);
        p.columns.push_back(row / 2);
        p.weights.push_back(1.0);
    }
    p.starts.push_back(rows);
    p.places.resize(p.coarse_rows);
    BlockGalerkin galerkin(graph, places, p);
    ASSERT_EQ(galerkin.coarse_graph().edges.size(), rows / 2);
    BlockMatrix coarse(galerkin.coarse_pattern(), BlockForm::symmetric);
    for (int n = 0; n < 2; ++n) galerkin.compute(fine, coarse);  // nothing stays from before
    for (std::size_t e = 0; e < rows / 2; ++e) {
        const SymmetricBlock k = coarse.coupling(galerkin.coarse_places()[e]);
        const Numbers numbers{k.xx, k.xy, k.xz, k.yy, k.yz, k.zz};
        EXPECT_EQ(numbers, joint);
        EXPECT_EQ(coarse.own_block(e).xx, 6.0);
        EXPECT_EQ(coarse.own_block(e).yy, 2.0);
        EXPECT_EQ(galerkin.coarse_graph().edges[e].weight, 1.0);
    }
}

// In double: the blocks of an example, some couplings in two parts.
class CholeskyExample {
public:
    explicit CholeskyExample(const BlockExample& e) : e_(e) {
        for (const RowGraph::Edge& edge : e.graph.edges) couplings_.push_back({edge.q, edge.p});
        couplings_.push_back({e.graph.edges[0].p, e.graph.edges[0].q});
        factorisation_ = std::make_unique<BlockCholesky>(e.graph.rows(), couplings_);
    }
    bool factor(double shift) {
        factorisation_->clear();
        for (std::size_t row = 0; row < e_.graph.rows(); ++row) {
            SymmetricBlock b = e_.matrix.own_block(row);
            b.xx += shift, b.yy += shift, b.zz += shift;
            factorisation_->add_own(row, b);
        }
        for (std::size_t c = 0; c < couplings_.size(); ++c) {
            factorisation_->add_coupling(c, block(c));
        }
        return factorisation_->factor();
    }
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) {
        std::vector<double> b(right.begin(), right.end()), x(b.size());
        factorisation_->solve(b, x);
        return Eigen::Map<Eigen::VectorXd>(x.data(), right.size());
    }

private:
    [[nodiscard]] SymmetricBlock block(std::size_t c) const {
        const bool first = c == 0 || c == e_.graph.edges.size();
        SymmetricBlock k = e_.matrix.coupling(e_.places[first ? 0 : c]);
        if (!first) return k;
        for (double* n : {&k.xx, &k.xy, &k.xz, &k.yy, &k.yz, &k.zz}) *n *= 0.5;
        return k;
    }

    const BlockExample& e_;
    std::vector<Coupling> couplings_;
    std::unique_ptr<BlockCholesky> factorisation_;
};

TEST(BlockCholesky, SolvesAsADenseFactorisationDoes) {
    const BlockExample e(17, 12, BlockForm::symmetric, false);
    CholeskyExample cholesky(e);
    const Eigen::VectorXd right =
        as_dense(random_block_vector(e.graph, e.pattern.slices(), 9), e.graph.rows());
    for (const double shift : {0.0, 2.0, 0.0}) {
        ASSERT_TRUE(cholesky.factor(shift));
        Eigen::MatrixXd a = e.dense();
        a.diagonal().array() += shift;
        const Eigen::VectorXd expected = a.ldlt().solve(right);
        EXPECT_LT((cholesky.solve(right) - expected).norm(), 1e-12 * expected.norm());
    }
}

TEST(BlockCholesky, SaysThatAMatrixIsNotPositive) {
    const BlockExample e(17, 12, BlockForm::symmetric, false);
    CholeskyExample cholesky(e);
    EXPECT_FALSE(cholesky.factor(-1.0));
    EXPECT_TRUE(cholesky.factor(0.0));  // and goes on
    EXPECT_FALSE(cholesky.factor(std::nan("")));
}

TEST(BlockCholesky, TakesAMatrixWithoutRows) {
    BlockCholesky cholesky(0, {});
    cholesky.clear();
    EXPECT_TRUE(cholesky.factor());
    cholesky.solve({}, {});
}

}  // namespace
}  // namespace weft::test
