// Kernels of block matrices on every instruction set against dense matrices.
#include <gtest/gtest.h>

#include "math/block_kernel.h"
#include "math/parallel.h"
#include "support/block_examples.h"

namespace weft::test {
namespace {

constexpr double single = 2e-6;  // relative, of sums of some ten products in float

struct Size {
    std::size_t columns, rows;
};
constexpr Size sizes[] = {{1, 1}, {2, 1}, {5, 3}, {16, 1}, {17, 2}, {33, 7}, {40, 31}};

template <typename Check>
void for_examples(const Check& check) {
    for (const Size size : sizes) {
        for (const BlockForm form : {BlockForm::spring, BlockForm::symmetric}) {
            for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
                SCOPED_TRACE(instruction_sets()[set]);
                BlockExample example(size.columns, size.rows, form);
                check(example,
                      BlockKernel(example.pattern.slices(), static_cast<InstructionSet>(set)));
            }
        }
    }
}

void expect_near(const BlockVector& found, const Eigen::VectorXd& expected) {
    const std::size_t rows = static_cast<std::size_t>(expected.size()) / 3;
    EXPECT_LT((as_dense(found, rows) - expected).norm(), single * (expected.norm() + 1e-30));
    for (std::size_t row = 0; row < rows && found.records.size() > 0; ++row) {
        const float* const record = found.records.data() + 4 * row;
        EXPECT_EQ((Vec3d{record[0], record[1], record[2]}), found[row]);
    }
    double padding = 0.0;
    for (std::size_t row = rows; row < found.values.size() / 3; ++row) {
        padding += length(found[row]);
    }
    EXPECT_EQ(padding, 0.0);
}

// What rows that take part have of a vector.
Eigen::VectorXd masked(const BlockExample& e, Eigen::VectorXd v) {
    for (std::size_t row = 0; row < e.graph.rows(); ++row) {
        if (e.graph.takes_part[row] == 0) v.segment<3>(static_cast<Eigen::Index>(3 * row)) *= 0.0;
    }
    return v;
}

// The inverse of A's diagonal blocks times v.
Eigen::VectorXd divided(const BlockExample& e, Eigen::VectorXd v) {
    const Eigen::MatrixXd a = e.dense();
    for (Eigen::Index n = 0; n < v.size(); n += 3) {
        v.segment<3>(n) = a.block<3, 3>(n, n).ldlt().solve(Eigen::Vector3d(v.segment<3>(n)));
    }
    return masked(e, v);
}

TEST(BlockKernel, MultipliesAsTheDenseMatrix) {
    for_examples([](BlockExample& e, BlockKernel kernel) {
        const std::size_t rows = e.graph.rows();
        const BlockVector u = random_block_vector(e.graph, e.pattern.slices(), 1);
        const BlockVector b = random_block_vector(e.graph, e.pattern.slices(), 2);
        BlockVector out(e.pattern.slices(), true);
        const Eigen::VectorXd product = masked(e, e.dense() * as_dense(u, rows));
        const double sum = kernel.product(e.matrix, u, out);
        expect_near(out, product);
        EXPECT_NEAR(sum, product.dot(as_dense(u, rows)), single * (sum + 1e-30));
        kernel.residual(e.matrix, u, b, out);
        expect_near(out, as_dense(b, rows) - product);
    });
}

TEST(BlockKernel, DividesByTheDiagonalBlocks) {
    for_examples([](BlockExample& e, BlockKernel kernel) {
        const std::size_t rows = e.graph.rows();
        kernel.factor(e.matrix);
        const BlockVector u = random_block_vector(e.graph, e.pattern.slices(), 1);
        const BlockVector b = random_block_vector(e.graph, e.pattern.slices(), 2);
        BlockVector out(e.pattern.slices(), true);
        const Eigen::VectorXd dense_u = as_dense(u, rows), dense_b = as_dense(b, rows);
        const double sum = kernel.precondition(e.matrix, 0.7, b, out);
        const Eigen::VectorXd quotient = 0.7 * divided(e, dense_b);
        expect_near(out, quotient);
        EXPECT_NEAR(sum, quotient.dot(dense_b), 10 * single * (sum + 1e-30));
        const double smoothed_sum = kernel.smooth(e.matrix, 0.7, u, b, out);
        const Eigen::VectorXd smoothed =
            dense_u + 0.7 * divided(e, dense_b - masked(e, e.dense() * dense_u));
        expect_near(out, smoothed);
        EXPECT_NEAR(smoothed_sum, smoothed.dot(dense_b),
                    single * (smoothed.norm() * dense_b.norm() + 1e-30));
    });
}

TEST(BlockKernel, ShiftsTheDiagonalByAFractionOfItsTrace) {
    for_examples([](BlockExample& e, BlockKernel kernel) {
        const Eigen::MatrixXd before = e.dense();
        kernel.factor(e.matrix, 0.01);
        const Eigen::MatrixXd after = e.dense();
        for (std::size_t row = 0; row < e.graph.rows(); ++row) {
            const auto n = static_cast<Eigen::Index>(3 * row);
            const double trace =
                e.graph.takes_part[row] != 0 ? before.block<3, 3>(n, n).trace() : 0.0;
            EXPECT_NEAR(after(n, n) - before(n, n), 0.01 * trace, 1e-5 * trace);
        }
    });
}

TEST(BlockKernel, AdvancesAndTurns) {
    for_examples([](BlockExample& e, BlockKernel kernel) {
        const std::size_t rows = e.graph.rows(), slices = e.pattern.slices();
        const BlockVector p = random_block_vector(e.graph, slices, 1);
        const BlockVector q = random_block_vector(e.graph, slices, 2);
        BlockVector d = random_block_vector(e.graph, slices, 3);
        BlockVector r = random_block_vector(e.graph, slices, 4);
        const Eigen::VectorXd next_d = as_dense(d, rows) + 0.3 * as_dense(p, rows);
        const Eigen::VectorXd next_r = as_dense(r, rows) - 0.3 * as_dense(q, rows);
        const double square = kernel.advance(0.3, p, q, d, r);
        EXPECT_LT((as_dense(d, rows) - next_d).norm(), single * (next_d.norm() + 1e-30));
        EXPECT_LT((as_dense(r, rows) - next_r).norm(), single * (next_r.norm() + 1e-30));
        EXPECT_NEAR(square, next_r.squaredNorm(), single * (square + 1e-30));
        BlockVector turned = random_block_vector(e.graph, slices, 5);
        const Eigen::VectorXd expected = as_dense(p, rows) - 1.5 * as_dense(turned, rows);
        kernel.direction(-1.5, p, turned);
        expect_near(turned, expected);
    });
}

// Blocks as ill conditioned as float has digits: stiff in a plane that lies askew, and light.
TEST(BlockKernel, DividesByBlocksBeyondTheDigitsOfFloat) {
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        const BlockPattern pattern(2, std::vector<Coupling>{{0, 1}, {0, 1}});
        BlockMatrix a(pattern, BlockForm::spring);
        const Vec3d g{600.0, 500.0, -700.0}, h{300.0, -900.0, 100.0};
        a.set_spring(pattern.place(0), 0.0, g);
        a.set_spring(pattern.place(1), 0.0, h);
        a.set_own(0, {1e-3, 0.0, 0.0, 1e-3, 0.0, 1e-3});
        BlockKernel kernel(pattern.slices(), static_cast<InstructionSet>(set));
        kernel.factor(a);
        const Vec3d normal = cross(g, h) / length(cross(g, h));
        BlockVector b(1, false), out(1, false);
        b.set(0, normal);
        EXPECT_GT(kernel.precondition(a, 1.0, b, out), 0.0);
        EXPECT_LT(length(out[0] - 1e3 * normal), 1e-3 * 1e3) << instruction_sets()[set];
        b.set(0, g);  // 1 / (g.g) g, but for what h takes
        EXPECT_GT(kernel.precondition(a, 1.0, b, out), 0.0);
        EXPECT_GT(dot(out[0], g), 0.9);
        EXPECT_LT(dot(out[0], g), 1.5);
    }
}

TEST(BlockKernel, GivesTheSameBitsOfAnyNumberOfThreads) {
    BlockExample e(150, 140, BlockForm::spring);
    const BlockVector b = random_block_vector(e.graph, e.pattern.slices(), 2);
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        std::vector<BlockVector> results;
        std::vector<double> sums;
        for (const int threads : {1, 2, 7}) {
            BlockVector out(e.pattern.slices(), true), r(e.pattern.slices(), true);
            ThreadTeam(threads).run([&] {
                BlockKernel kernel(e.pattern.slices(), static_cast<InstructionSet>(set));
                kernel.factor(e.matrix);
                kernel.smooth(e.matrix, 0.6, b, b, out);
                sums.push_back(kernel.product(e.matrix, out, r));
            });
            results.push_back(std::move(r));
        }
        for (std::size_t n = 1; n < results.size(); ++n) {
            EXPECT_EQ(sums[n], sums[0]);
            for (std::size_t i = 0; i < results[0].values.size(); ++i) {
                ASSERT_EQ(results[n].values.data()[i], results[0].values.data()[i]);
            }
        }
    }
}

}  // namespace
}  // namespace weft::test
