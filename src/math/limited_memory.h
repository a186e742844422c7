// The limited-memory BFGS approximation of an inverse Hessian.
#pragma once

#include <cstddef>
#include <vector>

#include "math/vec3_array.h"

namespace weft {

/// The last pairs of steps s and changes of gradient y, in the two loops of Nocedal and Wright,
/// Numerical Optimization, algorithm 7.4: H r is
///     before(r);  r = H0 r, by the caller;  after(r).
class LimitedMemory {
public:
    /// @param size of all arrays.
    /// @param pairs kept at most; 0: H = H0.
    LimitedMemory(std::size_t size, std::size_t pairs);
    LimitedMemory() = default;

    void clear() { count_ = 0; }

    /// Takes s = x_new - x_old and y = g_new - g_old, in place of the oldest pair if all are taken.
    /// A pair without positive curvature, s.y <= 0 to rounding, is passed over.
    void add(const Vec3Array<double>& x_new, const Vec3Array<double>& x_old,
             const Vec3Array<double>& g_new, const Vec3Array<double>& g_old);

    void before(Vec3Array<double>& r);
    void after(Vec3Array<double>& r) const;

private:
    struct Pair {
        Vec3Array<double> s, y;
        double inverse_curvature = 0.0;  // 1 / s.y
        double weight = 0.0;             // of the first loop, for the second
    };
    // The pair added `age` pairs before the newest.
    [[nodiscard]] std::size_t place(std::size_t age) const {
        return (next_ + pairs_.size() - 1 - age) % pairs_.size();
    }

    std::vector<Pair> pairs_;
    std::size_t count_ = 0, next_ = 0;
};

}  // namespace weft
