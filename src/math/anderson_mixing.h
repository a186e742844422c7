// Anderson's acceleration of a fixed-point iteration x <- x + d(x).
#pragma once

#include <cstddef>
#include <vector>

#include "math/vec3_array.h"

namespace weft {

/// Anderson (1965) J. ACM 12, 547, as Walker and Ni (2011) SIAM J. Numer. Anal. 49, 1715, state it
/// (type II). With the changes dX of x and dD of d over the last iterations, it moves by
///     p = d - (dX + dD) g,    g = argmin |d - dD g|,
/// which on a linear problem does what GMRES does, whether or not d comes from a gradient.
class AndersonMixing {
public:
    /// @param size of all arrays.
    /// @param pairs of changes kept at most.
    AndersonMixing(std::size_t size, std::size_t pairs);
    AndersonMixing() = default;

    /// Forgets all iterations.
    void clear() { count_ = taken_ = 0; }

    /// Takes an iterate x and its d; makes p of d. Changes by which the smallest g cannot be told,
    /// since they hang together to rounding, are left out.
    void mix(const Vec3Array<double>& x, Vec3Array<double>& d);

private:
    struct Pair {
        Vec3Array<double> x, d;  // changes, or the iterate they will be counted from
    };
    void solve(std::size_t pairs);

    std::vector<Pair> pairs_;  // a ring; the newest holds x and d themselves
    std::size_t count_ = 0, taken_ = 0;
    std::vector<double> gram_, weights_;
};

}  // namespace weft
