// The largest eigenvalue of a symmetric positive semidefinite operator that is known only by its
// products, with a warm start: the locally optimal conjugate gradient method (Knyazev 2001,
// LOBPCG with one vector). Each iteration costs one product and takes the best vector in the span
// of the present one, its residual and the last direction; plain power iteration needs several
// times as many products for the closely set top frequencies of a cloth.
//
// Beside the product, an iteration is one sweep over the arrays (math/ritz_pass.h): it combines the
// vectors and sums all scalar products but that of the residual with its own image.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "math/parallel.h"
#include "math/ritz_pass.h"
#include "math/ritz_step.h"
#include "math/vec3_array.h"

namespace weft {

/// How far to go.
struct SearchEffort {
    /// Estimated relative error of the value at which to stop: what is to be gained yet if gains go
    /// on shrinking as in the last iterations.
    double tolerance = 1e-6;
    int least_products = 0;  ///< before which the estimate is not trusted
    int most_products = 200;
};

struct EigenvalueResult {
    double value = 0.0;
    int products = 0;        ///< operator applications spent
    bool converged = false;  ///< the estimated error was below the tolerance
};

/// Scalar product in double, of blocks summed in order.
template <typename Real>
double dot_product(const Vec3Array<Real>& a, const Vec3Array<Real>& b) {
    constexpr std::size_t lanes = 8, block = 1024;
    double sum = 0.0;
    for (std::size_t first = 0; first < a.data_size(); first += block) {
        const std::size_t last = std::min(first + block, a.data_size());  // whole cache lines
        std::array<double, lanes> sums{};
        for (std::size_t i = first; i < last; i += lanes) {
            for (std::size_t l = 0; l < lanes; ++l) {
                sums[l] +=
                    static_cast<double>(a.data()[i + l]) * static_cast<double>(b.data()[i + l]);
            }
        }
        for (const double lane : sums) sum += lane;
    }
    return sum;
}

template <typename Real>
class LargestEigenvalue {
public:
    explicit LargestEigenvalue(std::size_t size, InstructionSet set = chosen_instruction_set())
        : x_(size), p_(size), r_(size), ax_(size), ap_(size), ar_(size) {
        if constexpr (sizeof(Real) == 4) {
            function_ = ritz_pass_single(set);
        } else {
            function_ = ritz_pass_double(set);
        }
        pass_ = {x_.data(),  p_.data(),  r_.data(),     ax_.data(),
                 ap_.data(), ar_.data(), x_.data_size()};
        block_sums_.resize(pass_.blocks());
        pass_.sums = block_sums_.data();
    }
    LargestEigenvalue(const LargestEigenvalue&) = delete;
    LargestEigenvalue& operator=(const LargestEigenvalue&) = delete;

    /// The unit eigenvector found; set it before the first call (anything but zero).
    Vec3Array<Real>& vector() { return x_; }

    /// Improves value and vector from the present vector.
    /// @param multiply (in, out): out = A in; may return in.out as a double.
    template <typename Multiply>
    EigenvalueResult iterate(const Multiply& multiply, const SearchEffort& effort) {
        EigenvalueResult result;
        const double squared = dot_product(x_, x_);
        if (!(squared > 1e-60) || !std::isfinite(squared)) return result;
        p_.fill_zero(), ap_.fill_zero(), r_.fill_zero(), ar_.fill_zero();
        const double rayleigh = product(multiply, x_, ax_) / squared;
        result.products = 1;
        sweep({0.0, 0.0, 0.0, 1.0 / std::sqrt(squared), rayleigh});
        result.value = sums_.x_ax / sums_.xx;
        RemainingGain gain;
        while (result.products < effort.most_products && !result.converged) {
            constexpr double noise = sizeof(Real) == 4 ? 1e-6 : 1e-14;  // of a residual
            if (!(std::sqrt(sums_.rr) > noise * result.value)) {
                result.converged = true;
                break;
            }
            const double r_ar = product(multiply, r_, ar_);
            ++result.products;
            sweep(ritz_step(sums_, r_ar, sizeof(Real) == 4 ? 1e-5 : 1e-12));
            const double before = std::exchange(result.value, sums_.x_ax / sums_.xx);
            gain.add(result.value - before);
            result.converged = result.products >= effort.least_products &&
                               gain.remaining() <= effort.tolerance * result.value;
        }
        return result;
    }

private:
    template <typename Multiply>
    static double product(const Multiply& multiply, const Vec3Array<Real>& in,
                          Vec3Array<Real>& out) {
        if constexpr (std::is_void_v<decltype(multiply(in, out))>) {
            multiply(in, out);
            return dot_product(in, out);
        } else {
            return multiply(in, out);
        }
    }

    void sweep(const RitzStep& step) {
        pass_.direction_x = static_cast<Real>(step.direction_x);
        pass_.direction_p = static_cast<Real>(step.direction_p);
        pass_.direction_r = static_cast<Real>(step.direction_r);
        pass_.vector_x = static_cast<Real>(step.vector_x);
        pass_.value = static_cast<Real>(step.value);
        constexpr std::size_t grain = 32;  // blocks worth a thread of their own
        parallel_for(block_sums_.size(), grain,
                     [&](std::size_t begin, std::size_t end) { function_(pass_, begin, end); });
        sums_ = {};
        for (const RitzSums& block : block_sums_) sums_ += block;
    }

    Vec3Array<Real> x_, p_, r_, ax_, ap_, ar_;
    RitzPass<Real> pass_;
    RitzFunction<Real> function_;
    std::vector<RitzSums> block_sums_;
    RitzSums sums_;
};

}  // namespace weft
