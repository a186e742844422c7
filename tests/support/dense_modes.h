// The modes of a sheet at rest from dense matrices: M^-1/2 K M^-1/2 of a plain list of springs.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <set>

#include "support/naive_cloth.h"

namespace weft::test {

/// The mass-scaled stiffness matrix of the grid at rest, pinned particles left out; spring by
/// spring k n n^T.
inline Eigen::MatrixXd dense_stiffness(const SceneDescription& scene,
                                       const std::set<std::size_t>& pinned) {
    const NaiveCloth cloth(scene);
    const std::vector<double> masses = cloth.masses();
    const std::size_t columns = static_cast<std::size_t>(scene.cloth.grid.resolution[0]);
    const auto size = static_cast<Eigen::Index>(3 * masses.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    const auto place = [&](std::size_t p) {
        const auto& grid = scene.cloth.grid;
        return Eigen::Vector3d{
            static_cast<double>(p % columns) * grid.size[0] / (grid.resolution[0] - 1),
            -static_cast<double>(p / columns) * grid.size[1] / (grid.resolution[1] - 1), 0.0};
    };
    const auto root = [&](std::size_t p) {
        return pinned.contains(p) ? 0.0 : 1.0 / std::sqrt(masses[p]);
    };
    for (const NaiveCloth::Spring& s : cloth.springs()) {
        const Eigen::Vector3d n = (place(s.q) - place(s.p)).normalized();
        const Eigen::Matrix3d k = s.k * n * n.transpose();
        const auto p = static_cast<Eigen::Index>(3 * s.p), q = static_cast<Eigen::Index>(3 * s.q);
        matrix.block<3, 3>(p, p) += root(s.p) * root(s.p) * k;
        matrix.block<3, 3>(q, q) += root(s.q) * root(s.q) * k;
        matrix.block<3, 3>(p, q) -= root(s.p) * root(s.q) * k;
        matrix.block<3, 3>(q, p) -= root(s.p) * root(s.q) * k;
    }
    return matrix;
}

inline double dense_omega_max(const SceneDescription& scene,
                              const std::set<std::size_t>& pinned = {}) {
    const Eigen::MatrixXd matrix = dense_stiffness(scene, pinned);
    return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
                         .eigenvalues()
                         .maxCoeff());
}

}  // namespace weft::test
