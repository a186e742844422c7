#include "math/anderson_mixing.h"

#include <algorithm>
#include <cmath>

#include "math/dot_product.h"

namespace weft {

namespace {

// to = from - to
void subtract_from(const Vec3Array<double>& from, Vec3Array<double>& to) {
    const double* const a = from.data();
    double* const b = to.data();
    for (std::size_t n = 0; n < to.data_size(); ++n) b[n] = a[n] - b[n];
}

}  // namespace

AndersonMixing::AndersonMixing(std::size_t size, std::size_t pairs)
    : pairs_(pairs + 1), gram_(pairs * pairs), weights_(pairs) {
    for (Pair& pair : pairs_) pair.x = pair.d = Vec3Array<double>(size);
}

// Cholesky's factorisation of the changes' scalar products, newest first, as far as they are
// independent; weights_ becomes g.
void AndersonMixing::solve(std::size_t pairs) {
    const auto entry = [&](std::size_t i, std::size_t j) -> double& {
        return gram_[i * weights_.size() + j];
    };
    constexpr double dependent = 1e-10;
    std::size_t rank = 0;
    for (; rank < pairs; ++rank) {
        const double whole = entry(rank, rank);
        for (std::size_t j = 0; j <= rank; ++j) {
            double rest = entry(rank, j);
            for (std::size_t k = 0; k < j; ++k) rest -= entry(rank, k) * entry(j, k);
            if (j < rank) {
                entry(rank, j) = rest / entry(j, j);
            } else {
                entry(rank, j) = rest > dependent * whole ? std::sqrt(rest) : 0.0;
            }
        }
        if (!(entry(rank, rank) > 0.0)) break;
    }
    for (std::size_t i = 0; i < pairs; ++i) {
        if (i >= rank) weights_[i] = 0.0;
    }
    for (std::size_t i = 0; i < rank; ++i) {
        for (std::size_t k = 0; k < i; ++k) weights_[i] -= entry(i, k) * weights_[k];
        weights_[i] /= entry(i, i);
    }
    for (std::size_t i = rank; i-- > 0;) {
        for (std::size_t k = i + 1; k < rank; ++k) weights_[i] -= entry(k, i) * weights_[k];
        weights_[i] /= entry(i, i);
    }
}

void AndersonMixing::mix(const Vec3Array<double>& x, Vec3Array<double>& d) {
    const std::size_t room = pairs_.size();
    const auto place = [&](std::size_t age) { return (taken_ + room - 1 - age) % room; };
    if (count_ > 0) {  // the last iterate becomes a change
        Pair& last = pairs_[place(0)];
        subtract_from(x, last.x);
        subtract_from(d, last.d);
    }
    const std::size_t changes = count_;
    Pair& now = pairs_[taken_ % room];
    now.x = x;
    now.d = d;
    for (std::size_t i = 0; i < changes; ++i) {
        const Vec3Array<double>& di = pairs_[place(i)].d;
        weights_[i] = dot(di, d);
        for (std::size_t j = 0; j <= i; ++j) {
            gram_[i * weights_.size() + j] = dot(di, pairs_[place(j)].d);
        }
    }
    solve(changes);
    double* const to = d.data();
    for (std::size_t i = 0; i < changes; ++i) {
        const Pair& pair = pairs_[place(i)];
        const double weight = weights_[i];
        const double *const dx = pair.x.data(), *const dd = pair.d.data();
        for (std::size_t n = 0; n < d.data_size(); ++n) to[n] -= weight * (dx[n] + dd[n]);
    }
    taken_ = (taken_ + 1) % room;
    count_ = std::min(count_ + 1, room - 1);
}

}  // namespace weft
