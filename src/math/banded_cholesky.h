// Cholesky's factorisation of a symmetric, positive definite matrix with few diagonals, within its
// band: n w^2 operations for n rows and w diagonals below the main one.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace weft {

class BandedCholesky {
public:
    /// A = 0 of so many rows, and diagonals below the main one. Nothing else allocates.
    BandedCholesky(std::size_t size, std::size_t band)
        : size_(size), band_(band), columns_(size * (band + 1)) {}

    [[nodiscard]] std::size_t size() const { return size_; }

    void set_zero();

    /// A's entry; after factor(): L's.
    /// @pre column <= row <= column + band, row < size.
    double& entry(std::size_t row, std::size_t column) {
        return columns_[column * (band_ + 1) + row - column];
    }

    /// A = L L^T.
    /// @return whether A is positive definite as far as rounding shows; else solve() must not be
    ///         called.
    bool factor();

    /// b becomes A^-1 b. [size]
    void solve(std::span<double> b) const;

private:
    // How many entries of a column stand below the main diagonal.
    [[nodiscard]] std::size_t below(std::size_t column) const {
        return column + band_ < size_ ? band_ : size_ - 1 - column;
    }

    std::size_t size_, band_;
    std::vector<double> columns_;  // [column][row - column]
};

}  // namespace weft
