// The largest eigenvalue against dense solvers and closed forms.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>

#include "math/largest_eigenvalue.h"
#include "math/random.h"

namespace weft::test {
namespace {

template <typename Real>
void randomise(Vec3Array<Real>& vector) {
    for (std::size_t p = 0; p < vector.size(); ++p) {
        const auto random = [&](std::uint64_t n) {
            return static_cast<Real>(random_uniform(1, n, p) - 0.5);
        };
        vector.set(p, {random(0), random(1), random(2)});
    }
}

// out = A in, with the vectors laid out as (x0, y0, z0, x1, ...).
auto multiply_by(const Eigen::MatrixXd& matrix) {
    return [&matrix](const Vec3Array<double>& in, Vec3Array<double>& out) {
        Eigen::VectorXd u(matrix.cols());
        for (std::size_t p = 0; p < in.size(); ++p) {
            const auto at = static_cast<Eigen::Index>(3 * p);
            u.segment<3>(at) = Eigen::Vector3d{in[p].x, in[p].y, in[p].z};
        }
        const Eigen::VectorXd product = matrix * u;
        for (std::size_t p = 0; p < out.size(); ++p) {
            const auto at = static_cast<Eigen::Index>(3 * p);
            out.set(p, {product(at), product(at + 1), product(at + 2)});
        }
    };
}

Eigen::MatrixXd random_semidefinite(Eigen::Index size, std::uint64_t seed) {
    Eigen::MatrixXd factor(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
        for (Eigen::Index j = 0; j < size; ++j) {
            factor(i, j) =
                random_uniform(seed, static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j)) -
                0.5;
        }
    }
    return factor * factor.transpose();
}

TEST(LargestEigenvalue, OfRandomMatricesIsTheDenseOne) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Eigen::MatrixXd matrix = random_semidefinite(30, seed);
        const double expected =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().maxCoeff();
        LargestEigenvalue<double> search(10);
        randomise(search.vector());
        const EigenvalueResult found = search.iterate(multiply_by(matrix), 1e-12, 500);
        EXPECT_TRUE(found.converged);
        EXPECT_NEAR(found.value, expected, 1e-9 * expected);
        EXPECT_LE(found.value, expected * (1 + 1e-13));  // a Rayleigh quotient
        // The vector is a unit eigenvector.
        Vec3Array<double> image(10);
        multiply_by(matrix)(search.vector(), image);
        EXPECT_NEAR(dot_product(search.vector(), search.vector()), 1.0, 1e-9);
        EXPECT_NEAR(dot_product(search.vector(), image), expected, 1e-9 * expected);
    }
}

// The free chain of n points: 4 sin^2((n - 1) pi / 2 n) is the largest of closely set values.
TEST(LargestEigenvalue, OfALongChainConvergesInFewProducts) {
    constexpr std::size_t n = 200;
    const auto multiply = [](const Vec3Array<double>& in, Vec3Array<double>& out) {
        for (std::size_t p = 0; p < n; ++p) {
            Vec3d sum{};
            if (p > 0) sum += in[p] - in[p - 1];
            if (p + 1 < n) sum += in[p] - in[p + 1];
            out.set(p, sum);
        }
    };
    LargestEigenvalue<double> search(n);
    randomise(search.vector());
    const EigenvalueResult found = search.iterate(multiply, 1e-8, 200);
    const double s = std::sin((n - 1) * std::numbers::pi / (2 * n));
    EXPECT_NEAR(found.value, 4 * s * s, 1e-4);
    EXPECT_LE(found.products, 200);
}

TEST(LargestEigenvalue, IsFoundAtOnceFromAWarmStart) {
    const Eigen::MatrixXd matrix = random_semidefinite(30, 3);
    LargestEigenvalue<double> search(10);
    randomise(search.vector());
    const EigenvalueResult cold = search.iterate(multiply_by(matrix), 1e-12, 500);
    const EigenvalueResult warm = search.iterate(multiply_by(matrix), 1e-8, 500);
    EXPECT_LE(warm.products, 5);
    EXPECT_GT(cold.products, warm.products);
    EXPECT_NEAR(warm.value, cold.value, 1e-9 * cold.value);
}

TEST(LargestEigenvalue, OfNothingIsZero) {
    const auto nothing = [](const Vec3Array<double>&, Vec3Array<double>& out) { out.fill_zero(); };
    LargestEigenvalue<double> search(4);
    EXPECT_EQ(search.iterate(nothing, 1e-8, 50).value, 0.0);  // from a zero vector
    randomise(search.vector());
    const EigenvalueResult found = search.iterate(nothing, 1e-8, 50);
    EXPECT_EQ(found.value, 0.0);
    EXPECT_TRUE(found.converged);
}

TEST(PowerStep, ReturnsTheRayleighQuotientAndTurnsTowardsTheLargest) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6, 6);
    matrix.diagonal() << 4.0, 1.0, 0.5, 0.25, 0.0, 0.0;
    Vec3Array<double> vector(2), image(2);
    vector.set(0, {1.0, 1.0, 0.0});
    EXPECT_DOUBLE_EQ(power_step(multiply_by(matrix), vector, image), 2.5);
    EXPECT_DOUBLE_EQ(vector[0].x, 4.0 / std::sqrt(17.0));
    EXPECT_DOUBLE_EQ(vector[0].y, 1.0 / std::sqrt(17.0));
    double quotient = 0.0;
    for (int n = 0; n < 30; ++n) quotient = power_step(multiply_by(matrix), vector, image);
    EXPECT_NEAR(quotient, 4.0, 1e-12);
}

}  // namespace
}  // namespace weft::test
