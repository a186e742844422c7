// The largest eigenvalue of a symmetric positive semidefinite operator that is known only by its
// products, with a warm start: the locally optimal conjugate gradient method (Knyazev 2001,
// LOBPCG with one vector). Each iteration costs one product and takes the best vector in the span
// of the present one, its residual and the last direction; plain power iteration needs several
// times as many products for the closely set top frequencies of a cloth.
#pragma once

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "math/vec3_array.h"

namespace weft {

struct EigenvalueResult {
    double value = 0.0;
    int products = 0;        ///< operator applications spent
    bool converged = false;  ///< the last relative change was below the tolerance
};

/// Scalar product with one order of summation, in double.
template <typename Real>
double dot_product(const Vec3Array<Real>& a, const Vec3Array<Real>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.data_size(); ++i) {
        sum += static_cast<double>(a.data()[i]) * static_cast<double>(b.data()[i]);
    }
    return sum;
}

/// One step of power iteration: `vector` becomes A vector, normalised; `image` is work space.
/// @return the Rayleigh quotient before the step, at most the largest eigenvalue.
template <typename Real, typename Multiply>
double power_step(const Multiply& multiply, Vec3Array<Real>& vector, Vec3Array<Real>& image) {
    multiply(std::as_const(vector), image);
    const double squared = dot_product(vector, vector);
    const double quotient = squared > 0.0 ? dot_product(vector, image) / squared : 0.0;
    const double norm = std::sqrt(dot_product(image, image));
    if (norm > 0.0 && std::isfinite(norm)) {
        const Real scale = static_cast<Real>(1.0 / norm);
        for (std::size_t i = 0; i < vector.data_size(); ++i) {
            vector.data()[i] = scale * image.data()[i];
        }
    }
    return quotient;
}

template <typename Real>
class LargestEigenvalue {
public:
    explicit LargestEigenvalue(std::size_t size)
        : vector_(size),
          direction_(size),
          residual_(size),
          a_vector_(size),
          a_direction_(size),
          a_residual_(size) {}

    /// The unit eigenvector found; set it before the first call (anything but zero).
    Vec3Array<Real>& vector() { return vector_; }

    /// Improves value and vector from the present vector.
    /// @param multiply (in, out): out = A in.
    /// @param tolerance relative change of the value in one iteration at which to stop.
    template <typename Multiply>
    EigenvalueResult iterate(const Multiply& multiply, double tolerance, int max_products) {
        EigenvalueResult result;
        if (!normalise(vector_, nullptr)) return result;
        multiply(std::as_const(vector_), a_vector_);
        result.value = dot_product(vector_, a_vector_);
        result.products = 1;
        bool has_direction = false;
        while (result.products < max_products) {
            combine(residual_, {-result.value, 1.0, 0.0}, vector_, a_vector_, a_vector_);
            orthogonalise(residual_, nullptr, vector_, nullptr);
            if (!normalise(residual_, nullptr)) {
                result.converged = true;
                break;
            }
            multiply(std::as_const(residual_), a_residual_);
            ++result.products;
            if (has_direction) {
                orthogonalise(direction_, &a_direction_, vector_, &a_vector_);
                orthogonalise(direction_, &a_direction_, residual_, &a_residual_);
                has_direction = normalise(direction_, &a_direction_);
            }
            const double before = result.value;
            result.value = rayleigh_ritz(has_direction);
            has_direction = true;
            if (std::abs(result.value - before) <= tolerance * std::abs(result.value)) {
                result.converged = true;
                break;
            }
        }
        return result;
    }

private:
    // out = c0 a + c1 b + c2 c
    static void combine(Vec3Array<Real>& out, std::array<double, 3> c, const Vec3Array<Real>& a,
                        const Vec3Array<Real>& b, const Vec3Array<Real>& d) {
        const Real c0 = static_cast<Real>(c[0]), c1 = static_cast<Real>(c[1]),
                   c2 = static_cast<Real>(c[2]);
        for (std::size_t i = 0; i < out.data_size(); ++i) {
            out.data()[i] = c0 * a.data()[i] + c1 * b.data()[i] + c2 * d.data()[i];
        }
    }
    static void add_scaled(Vec3Array<Real>& out, double scale, const Vec3Array<Real>& a) {
        const Real s = static_cast<Real>(scale);
        for (std::size_t i = 0; i < out.data_size(); ++i) out.data()[i] += s * a.data()[i];
    }
    static void scale(Vec3Array<Real>& a, double factor) {
        const Real s = static_cast<Real>(factor);
        for (std::size_t i = 0; i < a.data_size(); ++i) a.data()[i] *= s;
    }
    static void orthogonalise(Vec3Array<Real>& a, Vec3Array<Real>* image,
                              const Vec3Array<Real>& unit, const Vec3Array<Real>* unit_image) {
        const double overlap = dot_product(a, unit);
        add_scaled(a, -overlap, unit);
        if (image != nullptr) add_scaled(*image, -overlap, *unit_image);
    }
    static bool normalise(Vec3Array<Real>& a, Vec3Array<Real>* image) {
        const double norm = std::sqrt(dot_product(a, a));
        if (!(norm > 1e-30) || !std::isfinite(norm)) return false;
        scale(a, 1.0 / norm);
        if (image != nullptr) scale(*image, 1.0 / norm);
        return true;
    }

    // The best unit vector in the span of the three; the direction becomes its part outside
    // vector_.
    double rayleigh_ritz(bool has_direction) {
        const int n = has_direction ? 3 : 2;
        const std::array<const Vec3Array<Real>*, 3> basis{&vector_, &residual_, &direction_};
        const std::array<const Vec3Array<Real>*, 3> image{&a_vector_, &a_residual_, &a_direction_};
        Eigen::MatrixXd projected(n, n);
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j <= i; ++j) {
                projected(i, j) = projected(j, i) = dot_product(
                    *basis[static_cast<std::size_t>(i)], *image[static_cast<std::size_t>(j)]);
            }
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(projected);
        const Eigen::VectorXd c = solver.eigenvectors().col(n - 1);
        const double c2 = has_direction ? c(2) : 0.0;
        combine(direction_, {c(1), c2, 0.0}, residual_, direction_, direction_);
        combine(a_direction_, {c(1), c2, 0.0}, a_residual_, a_direction_, a_direction_);
        combine(vector_, {c(0), 1.0, 0.0}, vector_, direction_, direction_);
        combine(a_vector_, {c(0), 1.0, 0.0}, a_vector_, a_direction_, a_direction_);
        return solver.eigenvalues()(n - 1);
    }

    Vec3Array<Real> vector_, direction_, residual_;
    Vec3Array<Real> a_vector_, a_direction_, a_residual_;
};

}  // namespace weft
