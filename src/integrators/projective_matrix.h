// Projective dynamics' constant matrix, factored once.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "cloth/spring_network.h"
#include "math/vec3_array.h"

namespace weft {

/// A = M / h^2 + sum over springs of (k + c / h) (e_p - e_q) (e_p - e_q)^T among the free
/// particles, the same for x, y and z, as L D L^T with fill reduced by approximate minimum degree.
class ProjectiveMatrix {
public:
    /// Takes the pattern, and finds the order of elimination.
    void analyse(const SpringNetwork& network);

    /// Computes L and D for step h [s].
    /// @param network as analysed.
    /// @return false where the factors are not finite or not positive.
    bool factor(const SpringNetwork& network, double h);

    /// d = A^-1 r for the free particles; d is zero elsewhere.
    void solve(const Vec3Array<double>& r, Vec3Array<double>& d);

    [[nodiscard]] std::size_t factor_entries() const { return rows_.size(); }

private:
    static constexpr std::size_t width = 4;  // three right-hand sides, and a place for vectors
    void fill(const SpringNetwork& network, double h);

    std::vector<std::uint32_t> slots_;       // [unknown]
    std::vector<std::uint32_t> unknown_of_;  // [slot]
    Eigen::SparseMatrix<double> matrix_;     // lower half
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt_;
    std::vector<std::uint32_t> order_;  // slots in order of elimination
    std::vector<std::size_t> first_;    // [column], and the end of the last: L's entries below 1
    std::vector<std::uint32_t> rows_;
    std::vector<double> values_, inverse_diagonal_;
    std::vector<double> work_;  // [unknown][width]
};

}  // namespace weft
