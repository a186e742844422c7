#include "math/ritz_step.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {

RitzStep ritz_step(const RitzSums& sums, double r_ar, double noise) {
    // Of x, r, p in this order.
    Eigen::Matrix3d gram, image;
    gram << sums.xx, sums.xr, sums.xp, sums.xr, sums.rr, sums.pr, sums.xp, sums.pr, sums.pp;
    image << sums.x_ax, sums.x_ar, sums.x_ap, sums.x_ar, r_ar, sums.p_ar, sums.x_ap, sums.p_ar,
        sums.p_ap;
    // An orthonormal basis of the span: columns of co-ordinates, made one by one (Gram-Schmidt).
    Eigen::Matrix3d basis = Eigen::Matrix3d::Zero();
    int size = 0;
    for (int n = 0; n < 3; ++n) {
        Eigen::Vector3d column = Eigen::Vector3d::Unit(n);
        for (int pass = 0; pass < 2; ++pass) {
            for (int m = 0; m < size; ++m) {
                column -= basis.col(m).dot(gram * column) * basis.col(m);
            }
        }
        const double squared = column.dot(gram * column);
        if (!(squared > noise * gram(n, n))) continue;
        basis.col(size++) = column / std::sqrt(squared);
    }
    const Eigen::Matrix3d projected = basis.transpose() * image * basis;  // zero outside the span
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(projected);
    Eigen::Vector3d best = solver.eigenvectors().col(2);
    if (best(0) < 0.0) best = -best;
    const double along = best(0);
    best(0) = 0.0;
    const Eigen::Vector3d direction = basis * best;
    return {direction(0), direction(2), direction(1), along * basis(0, 0), solver.eigenvalues()(2)};
}

void RemainingGain::add(double gain) {
    last_ = {last_[1], last_[2], std::max(gain, 0.0)};
}

double RemainingGain::remaining() const {
    const auto [first, second, third] = last_;
    if (first < 0.0) return std::numeric_limits<double>::infinity();
    if (third == 0.0) return 0.0;
    const double ratio = std::sqrt(third / std::max(first, third));
    return ratio < 1.0 ? third * ratio / (1.0 - ratio) : std::numeric_limits<double>::infinity();
}

}  // namespace weft
