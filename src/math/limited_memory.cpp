#include "math/limited_memory.h"

#include <cmath>

#include "math/dot_product.h"
#include "math/parallel.h"

namespace weft {

namespace {

constexpr std::size_t grain = 16384;  // below this, waking a thread costs more than the loop

void add_scaled(double weight, const Vec3Array<double>& x, Vec3Array<double>& y) {
    parallel_for(y.data_size(), grain, [&](std::size_t begin, std::size_t end) {
        const double* from = x.data();
        double* to = y.data();
        for (std::size_t n = begin; n < end; ++n) to[n] += weight * from[n];
    });
}

void subtract(const Vec3Array<double>& a, const Vec3Array<double>& b, Vec3Array<double>& out) {
    parallel_for(out.data_size(), grain, [&](std::size_t begin, std::size_t end) {
        const double *from = a.data(), *less = b.data();
        double* to = out.data();
        for (std::size_t n = begin; n < end; ++n) to[n] = from[n] - less[n];
    });
}

}  // namespace

LimitedMemory::LimitedMemory(std::size_t size, std::size_t pairs) : pairs_(pairs) {
    for (Pair& pair : pairs_) {
        pair.s = Vec3Array<double>(size);
        pair.y = Vec3Array<double>(size);
    }
}

void LimitedMemory::add(const Vec3Array<double>& x_new, const Vec3Array<double>& x_old,
                        const Vec3Array<double>& g_new, const Vec3Array<double>& g_old) {
    if (pairs_.empty()) return;
    Pair& pair = pairs_[next_];
    if (count_ == pairs_.size()) --count_;  // the oldest goes, whether or not the new one stays
    subtract(x_new, x_old, pair.s);
    subtract(g_new, g_old, pair.y);
    const double curvature = dot(pair.s, pair.y);
    const double scale = std::sqrt(dot(pair.s, pair.s) * dot(pair.y, pair.y));
    if (!(curvature > 1e-14 * scale)) return;
    pair.inverse_curvature = 1 / curvature;
    next_ = (next_ + 1) % pairs_.size();
    ++count_;
}

void LimitedMemory::before(Vec3Array<double>& r) {
    for (std::size_t age = 0; age < count_; ++age) {
        Pair& pair = pairs_[place(age)];
        pair.weight = pair.inverse_curvature * dot(pair.s, r);
        add_scaled(-pair.weight, pair.y, r);
    }
}

void LimitedMemory::after(Vec3Array<double>& r) const {
    for (std::size_t age = count_; age-- > 0;) {
        const Pair& pair = pairs_[place(age)];
        add_scaled(pair.weight - pair.inverse_curvature * dot(pair.y, r), pair.s, r);
    }
}

}  // namespace weft
