#include "integrators/projective_matrix.h"

#include <algorithm>
#include <cmath>

#include "integrators/spring_colours.h"

namespace weft {

namespace {

constexpr std::uint32_t none = 0xffffffff;

}  // namespace

void ProjectiveMatrix::analyse(const SpringNetwork& network) {
    slots_ = free_slots(network);
    unknown_of_.assign(network.inverse_masses.size(), none);
    for (std::uint32_t n = 0; n < slots_.size(); ++n) unknown_of_[slots_[n]] = n;
    work_.assign(slots_.size() * width, 0.0);
    if (slots_.empty()) return;
    fill(network, 1.0);
    ldlt_.analyzePattern(matrix_);
}

void ProjectiveMatrix::fill(const SpringNetwork& network, double h) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(slots_.size() + 3 * network.springs.size());
    const auto add = [&](std::uint32_t row, std::uint32_t column, double value) {
        entries.emplace_back(static_cast<int>(std::max(row, column)),
                             static_cast<int>(std::min(row, column)), value);
    };
    for (std::uint32_t n = 0; n < slots_.size(); ++n) {
        add(n, n, 1 / (network.inverse_masses[slots_[n]] * h * h));
    }
    for (const SpringNetwork::Spring& s : network.springs) {
        const std::uint32_t p = unknown_of_[s.p], q = unknown_of_[s.q];
        const double weight = s.stiffness + s.damping / h;
        if (p != none) add(p, p, weight);
        if (q != none) add(q, q, weight);
        if (p != none && q != none) add(p, q, -weight);
    }
    const auto size = static_cast<Eigen::Index>(slots_.size());
    matrix_.resize(size, size);
    matrix_.setFromTriplets(entries.begin(), entries.end());
}

bool ProjectiveMatrix::factor(const SpringNetwork& network, double h) {
    if (slots_.empty()) return true;
    fill(network, h);
    ldlt_.factorize(matrix_);
    const Eigen::VectorXd diagonal = ldlt_.vectorD();
    if (ldlt_.info() != Eigen::Success || !(diagonal.minCoeff() > 0.0) || !diagonal.allFinite()) {
        return false;
    }
    const auto& lower = ldlt_.matrixL().nestedExpression();
    const auto columns = static_cast<std::size_t>(lower.cols());
    const auto entries = static_cast<std::size_t>(lower.nonZeros());
    first_.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + columns + 1);
    rows_.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + entries);
    values_.assign(lower.valuePtr(), lower.valuePtr() + entries);
    inverse_diagonal_.resize(columns);
    order_.resize(columns);
    for (std::size_t n = 0; n < columns; ++n) {
        const auto index = static_cast<Eigen::Index>(n);
        inverse_diagonal_[n] = 1 / diagonal[index];
        const auto place = static_cast<std::size_t>(ldlt_.permutationP().indices()[index]);
        order_[place] = slots_[n];
    }
    return true;
}

void ProjectiveMatrix::solve(const Vec3Array<double>& r, Vec3Array<double>& d) {
    const std::size_t size = order_.size();
    const ConstVec3View<double> from = r.view();
    for (std::size_t n = 0; n < size; ++n) {
        const Vec3d value = from[order_[n]];
        double* w = &work_[n * width];
        w[0] = value.x, w[1] = value.y, w[2] = value.z;
    }
    for (std::size_t n = 0; n < size; ++n) {  // L z = r, column by column
        double w[width];
        std::copy_n(&work_[n * width], width, w);
        for (std::size_t e = first_[n]; e < first_[n + 1]; ++e) {
            double* below = &work_[rows_[e] * width];
            for (std::size_t c = 0; c < width; ++c) below[c] -= values_[e] * w[c];
        }
    }
    const Vec3View<double> to = d.view();
    for (std::size_t n = size; n-- > 0;) {  // L^T d = D^-1 z, row by row
        double w[width];
        for (std::size_t c = 0; c < width; ++c) w[c] = inverse_diagonal_[n] * work_[n * width + c];
        for (std::size_t e = first_[n]; e < first_[n + 1]; ++e) {
            const double* below = &work_[rows_[e] * width];
            for (std::size_t c = 0; c < width; ++c) w[c] -= values_[e] * below[c];
        }
        std::copy_n(w, width, &work_[n * width]);
        to.set(order_[n], {w[0], w[1], w[2]});
    }
}

}  // namespace weft
