// The largest eigenvalue against dense solvers and closed forms.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>
#include <vector>

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
        const EigenvalueResult found = search.iterate(multiply_by(matrix), {1e-12, 0, 500});
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
    const EigenvalueResult found = search.iterate(multiply, {1e-8, 0, 200});
    const double s = std::sin((n - 1) * std::numbers::pi / (2 * n));
    EXPECT_NEAR(found.value, 4 * s * s, 1e-4);
    EXPECT_LE(found.products, 200);
}

TEST(LargestEigenvalue, IsFoundAtOnceFromAWarmStart) {
    const Eigen::MatrixXd matrix = random_semidefinite(30, 3);
    LargestEigenvalue<double> search(10);
    randomise(search.vector());
    const EigenvalueResult cold = search.iterate(multiply_by(matrix), {1e-12, 0, 500});
    const EigenvalueResult warm = search.iterate(multiply_by(matrix), {1e-8, 0, 500});
    EXPECT_LE(warm.products, 5);
    EXPECT_GT(cold.products, warm.products);
    EXPECT_NEAR(warm.value, cold.value, 1e-9 * cold.value);
}

TEST(LargestEigenvalue, OfNothingIsZero) {
    const auto nothing = [](const Vec3Array<double>&, Vec3Array<double>& out) { out.fill_zero(); };
    LargestEigenvalue<double> search(4);
    EXPECT_EQ(search.iterate(nothing, {1e-8, 0, 50}).value, 0.0);  // from a zero vector
    randomise(search.vector());
    const EigenvalueResult found = search.iterate(nothing, {1e-8, 0, 50});
    EXPECT_EQ(found.value, 0.0);
    EXPECT_TRUE(found.converged);
}

// Every instruction set takes the same way, to rounding.
TEST(LargestEigenvalue, IsTheSameOfEveryInstructionSet) {
    const Eigen::MatrixXd matrix = random_semidefinite(3 * 41, 5);
    const double expected =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().maxCoeff();
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        LargestEigenvalue<double> search(41, static_cast<InstructionSet>(set));
        randomise(search.vector());
        EXPECT_NEAR(search.iterate(multiply_by(matrix), {1e-12, 0, 500}).value, expected,
                    1e-11 * expected)
            << instruction_sets()[set];
    }
}

// Two equal blocks: the search sees the second only if the noise of its start does.
TEST(LargestEigenvalue, KeepsOnForTheLeastNumberOfProducts) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6, 6);
    matrix.diagonal() << 4.0, 3.9, 3.8, 3.7, 3.6, 5.0;
    LargestEigenvalue<double> search(2);
    const auto start = [&] {
        search.vector().set(0, {1.0, 1e-3, 1e-3});
        search.vector().set(1, {1e-3, 1e-3, 1e-9});
    };
    start();
    EXPECT_LT(search.iterate(multiply_by(matrix), {1e-3, 0, 100}).value, 4.1);
    start();
    EXPECT_NEAR(search.iterate(multiply_by(matrix), {1e-3, 30, 100}).value, 5.0, 1e-6);
}

template <typename Real>
class RitzSweep : public ::testing::Test {
protected:
    static constexpr std::size_t size = 1024 * 3 + 16 * 5;

    // Six arrays of numbers in [-1, 1), one after the other.
    static std::vector<Vec3Array<Real>> arrays() {
        std::vector<Vec3Array<Real>> result;
        for (std::uint64_t n = 0; n < 6; ++n) {
            result.emplace_back(size);
            for (std::size_t i = 0; i < size; ++i) {
                result.back().data()[i] = static_cast<Real>(2 * random_uniform(2, n, i) - 1);
            }
        }
        return result;
    }
    static std::vector<RitzSums> run(InstructionSet set, std::vector<Vec3Array<Real>>& arrays,
                                     std::size_t split) {
        RitzPass<Real> pass{arrays[0].data(),
                            arrays[1].data(),
                            arrays[2].data(),
                            arrays[3].data(),
                            arrays[4].data(),
                            arrays[5].data(),
                            size};
        pass.direction_x = Real(0.25), pass.direction_p = Real(-1.5), pass.direction_r = Real(0.5);
        pass.vector_x = Real(0.75), pass.value = Real(1.25);
        std::vector<RitzSums> sums(pass.blocks());
        pass.sums = sums.data();
        const auto function = [&] {
            if constexpr (sizeof(Real) == 4) {
                return ritz_pass_single(set);
            } else {
                return ritz_pass_double(set);
            }
        }();
        function(pass, split, pass.blocks());
        function(pass, 0, split);
        return sums;
    }
};

using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RitzSweep, Precisions);

TYPED_TEST(RitzSweep, IsThePlainLoopsOfEveryInstructionSet) {
    const double tolerance = sizeof(TypeParam) == 4 ? 4e-7 : 4e-15;
    auto plain = this->arrays();
    const auto plain_sums = this->run(InstructionSet::scalar, plain, 0);
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        auto arrays = this->arrays();
        const auto sums = this->run(static_cast<InstructionSet>(set), arrays, 2);
        for (std::size_t n = 0; n < 6; ++n) {
            for (std::size_t i = 0; i < this->size; ++i) {
                ASSERT_NEAR(arrays[n].data()[i], plain[n].data()[i], 4 * tolerance);
            }
        }
        for (std::size_t n = 0; n < sums.size(); ++n) {  // of up to 1024 terms of order 1
            const double most = 1024 * tolerance;
            EXPECT_NEAR(sums[n].xx, plain_sums[n].xx, most);
            EXPECT_NEAR(sums[n].xp, plain_sums[n].xp, most);
            EXPECT_NEAR(sums[n].xr, plain_sums[n].xr, 4 * most);
            EXPECT_NEAR(sums[n].pp, plain_sums[n].pp, most);
            EXPECT_NEAR(sums[n].pr, plain_sums[n].pr, 4 * most);
            EXPECT_NEAR(sums[n].rr, plain_sums[n].rr, 8 * most);
            EXPECT_NEAR(sums[n].x_ax, plain_sums[n].x_ax, most);
            EXPECT_NEAR(sums[n].x_ap, plain_sums[n].x_ap, most);
            EXPECT_NEAR(sums[n].x_ar, plain_sums[n].x_ar, 4 * most);
            EXPECT_NEAR(sums[n].p_ap, plain_sums[n].p_ap, most);
            EXPECT_NEAR(sums[n].p_ar, plain_sums[n].p_ar, 4 * most);
        }
    }
}

// Gains of 8, 4, 2 foretell 1 + 1/2 + ... = 2 more.
TEST(RemainingGain, IsThatOfAGeometricSeries) {
    RemainingGain gain;
    EXPECT_TRUE(std::isinf(gain.remaining()));
    gain.add(8.0);
    gain.add(4.0);
    EXPECT_TRUE(std::isinf(gain.remaining()));
    gain.add(2.0);
    EXPECT_DOUBLE_EQ(gain.remaining(), 2.0);
    gain.add(4.0);
    EXPECT_TRUE(std::isinf(gain.remaining()));  // no longer shrinking
    gain.add(-1e-9);                            // rounding
    EXPECT_EQ(gain.remaining(), 0.0);
}

}  // namespace
}  // namespace weft::test
