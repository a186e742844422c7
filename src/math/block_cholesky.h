// Sparse Cholesky factorisation of symmetric matrices of 3 x 3 blocks, in double, by CHOLMOD (Chen,
// Davis, Hager and Rajamanickam, ACM TOMS 35, 2008): the order of elimination and the factor's
// structure are found once, values whenever they are new.
//
// CHOLMOD's supernodal module is under the GPL, weft under the MIT licence: it is used only where
// somebody asks for it by name, never by default.
#pragma once

#include <memory>
#include <span>

#include "math/block_matrix.h"

namespace weft {

class BlockCholesky {
public:
    /// Which of CHOLMOD's modules may factor.
    enum class Modules {
        all,         ///< the one that it expects to be faster; the supernodal is under the GPL
        simplicial,  ///< under the LGPL; slower on large matrices
    };

    /// @param couplings between different rows, each pair once; a pair that repeats adds up.
    BlockCholesky(std::size_t rows, std::span<const Coupling> couplings,
                  Modules modules = Modules::all);
    ~BlockCholesky();
    BlockCholesky(const BlockCholesky&) = delete;
    BlockCholesky& operator=(const BlockCholesky&) = delete;

    /// Makes the matrix zero.
    void clear();
    /// A_ii += B
    void add_own(std::size_t row, const SymmetricBlock& b);
    /// A_ii += K, A_jj += K, A_ij -= K, A_ji -= K for the c-th coupling (i, j).
    void add_coupling(std::size_t c, const SymmetricBlock& k);

    /// @return whether the matrix is positive definite, and there was memory enough for the factor.
    bool factor();

    /// x = A^-1 b, [3 row + component] both.
    /// @pre factor() returned true.
    void solve(std::span<const double> b, std::span<double> x);

    /// Numbers in the factor.
    [[nodiscard]] double factor_size() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace weft
