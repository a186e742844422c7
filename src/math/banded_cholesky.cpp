#include "math/banded_cholesky.h"

#include <algorithm>
#include <cmath>

namespace weft {

void BandedCholesky::set_zero() {
    std::fill(columns_.begin(), columns_.end(), 0.0);
}

bool BandedCholesky::factor() {
    for (std::size_t j = 0; j < size_; ++j) {
        double* const column = &entry(j, j);
        if (!(column[0] > 0.0) || !std::isfinite(column[0])) return false;
        const std::size_t count = below(j);
        column[0] = std::sqrt(column[0]);
        for (std::size_t n = 1; n <= count; ++n) column[n] /= column[0];
        for (std::size_t k = 1; k <= count; ++k) {
            double* const later = &entry(j + k, j + k) - k;
            const double factor = column[k];
            for (std::size_t n = k; n <= count; ++n) later[n] -= factor * column[n];
        }
    }
    return true;
}

void BandedCholesky::solve(std::span<double> b) const {
    for (std::size_t j = 0; j < size_; ++j) {
        const double* const column = &columns_[j * (band_ + 1)];
        b[j] /= column[0];
        const std::size_t count = below(j);
        for (std::size_t n = 1; n <= count; ++n) b[j + n] -= b[j] * column[n];
    }
    for (std::size_t j = size_; j-- > 0;) {
        const double* const column = &columns_[j * (band_ + 1)];
        double sum = b[j];
        const std::size_t count = below(j);
        for (std::size_t n = 1; n <= count; ++n) sum -= column[n] * b[j + n];
        b[j] = sum / column[0];
    }
}

}  // namespace weft
