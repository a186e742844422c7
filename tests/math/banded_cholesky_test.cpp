#include "math/banded_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "math/random.h"

namespace weft::test {
namespace {

double entry_of(std::size_t size, std::size_t i, std::size_t j) {
    const std::size_t low = std::min(i, j), high = std::max(i, j);
    return 2.0 * random_uniform(1, low * size + high, 0) - 1.0 + (i == j ? 20.0 : 0.0);
}

TEST(BandedCholesky, SolvesAsADenseFactorisation) {
    for (const auto& [size, band] : {std::pair<std::size_t, std::size_t>{1, 0},
                                     {1, 3},
                                     {5, 0},
                                     {5, 4},
                                     {7, 9},
                                     {40, 3},
                                     {60, 17}}) {
        BandedCholesky matrix(size, band);
        Eigen::MatrixXd dense =
            Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
        Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(size), 1.0, 2.0);
        for (const int time : {1, 2}) {  // the second after set_zero()
            matrix.set_zero();
            for (std::size_t j = 0; j < size; ++j) {
                for (std::size_t i = j; i < std::min(j + band + 1, size); ++i) {
                    const double value = time * entry_of(size, i, j);
                    matrix.entry(i, j) = value;
                    const auto row = static_cast<Eigen::Index>(i);
                    const auto column = static_cast<Eigen::Index>(j);
                    dense(row, column) = dense(column, row) = value;
                }
            }
            ASSERT_TRUE(matrix.factor());
            std::vector<double> found(b.data(), b.data() + b.size());
            matrix.solve(found);
            const Eigen::VectorXd expected = dense.llt().solve(b);
            EXPECT_LT((Eigen::Map<Eigen::VectorXd>(found.data(), b.size()) - expected).norm(),
                      1e-14 * expected.norm())
                << size << " " << band;
        }
    }
}

TEST(BandedCholesky, RefusesWhatIsNotPositiveDefinite) {
    BandedCholesky matrix(3, 1);
    EXPECT_FALSE(matrix.factor());
    const auto set = [&](double middle) {
        matrix.set_zero();
        for (std::size_t i = 0; i < 3; ++i) matrix.entry(i, i) = i == 1 ? middle : 2.0;
        for (std::size_t i = 0; i < 2; ++i) matrix.entry(i + 1, i) = -1.0;
    };
    set(1.5);
    EXPECT_TRUE(matrix.factor());
    set(0.9);  // 2 * 0.9 * 2 < 2 + 2
    EXPECT_FALSE(matrix.factor());
    set(std::nan(""));
    EXPECT_FALSE(matrix.factor());
}

}  // namespace
}  // namespace weft::test
