// Anderson's mixing on linear problems, where it is GMRES (Walker, Ni 2011).
#include "math/anderson_mixing.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace weft::test {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr int unknowns = 6;

// A rotation with growth: x <- x + d by itself goes round and outward.
Matrix outward() {
    Matrix a = Matrix::Zero(unknowns, unknowns);
    for (int n = 0; n < unknowns; n += 2) {
        a(n, n) = a(n + 1, n + 1) = 1.0;
        a(n, n + 1) = 1.0 + n;
        a(n + 1, n) = -1.0 - n;
    }
    return a;
}

Vec3Array<double> as_array(const Vector& v) {
    Vec3Array<double> array(2);
    for (std::size_t s = 0; s < 2; ++s) {
        const auto n = static_cast<Eigen::Index>(3 * s);
        array.set(s, {v(n), v(n + 1), v(n + 2)});
    }
    return array;
}

Vector as_vector(const Vec3Array<double>& array) {
    Vector v(unknowns);
    v << array[0].x, array[0].y, array[0].z, array[1].x, array[1].y, array[1].z;
    return v;
}

// |b - A x| after so many iterations x <- x + mixed (b - A x).
double residual_after(int iterations, std::size_t kept) {
    const Matrix a = outward();
    const Vector b = Vector::LinSpaced(unknowns, 1.0, 2.5);
    Vector x = Vector::Zero(unknowns);
    AndersonMixing mixing(2, kept);
    for (int n = 0; n < iterations; ++n) {
        Vec3Array<double> d = as_array(b - a * x);
        mixing.mix(as_array(x), d);
        x += as_vector(d);
    }
    return (b - a * x).norm();
}

TEST(AndersonMixing, SolvesALinearProblemInAsManyIterationsAsUnknowns) {
    EXPECT_LT(residual_after(unknowns + 2, unknowns), 1e-9);
}

TEST(AndersonMixing, WithoutItTheIterationRunsAway) {
    const Matrix a = outward();
    Vector x = Vector::Zero(unknowns);
    const Vector b = Vector::LinSpaced(unknowns, 1.0, 2.5);
    for (int n = 0; n < unknowns + 2; ++n) x += b - a * x;
    EXPECT_GT((b - a * x).norm(), 1e3);
}

// Past the solution changes are rounding: what hangs together is left out.
TEST(AndersonMixing, StaysAtTheSolution) {
    EXPECT_LT(residual_after(40, unknowns), 1e-9);
}

TEST(AndersonMixing, ForgetsWhatItIsToldTo) {
    AndersonMixing mixing(2, 3);
    Vec3Array<double> d = as_array(Vector::Ones(unknowns));
    mixing.mix(as_array(Vector::Zero(unknowns)), d);
    mixing.clear();
    Vec3Array<double> other = as_array(Vector::LinSpaced(unknowns, 0.0, 1.0));
    const Vector before = as_vector(other);
    mixing.mix(as_array(Vector::Ones(unknowns)), other);
    EXPECT_EQ(as_vector(other), before);
}

}  // namespace
}  // namespace weft::test
