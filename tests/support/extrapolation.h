// A reference solver for y' = f(t, y) that shares nothing with weft's integrators: the extrapolated
// midpoint rule of Gragg, Bulirsch and Stoer (Hairer, Norsett, Wanner, Solving ODEs I, II.9).
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace weft::test {

using Values = std::vector<double>;
/// slope(t, y, out): out = f(t, y).
using Slope = std::function<void(double, const Values&, Values&)>;

// Error expansion in even powers of step / parts.
inline Values midpoint_rule(const Slope& slope, double t, const Values& y, double step, int parts) {
    const double h = step / parts;
    Values before = y, now = y, k(y.size());
    slope(t, y, k);
    for (std::size_t i = 0; i < y.size(); ++i) now[i] += h * k[i];
    for (int n = 1; n < parts; ++n) {
        slope(t + n * h, now, k);
        for (std::size_t i = 0; i < y.size(); ++i) {
            const double after = before[i] + 2.0 * h * k[i];
            before[i] = now[i];
            now[i] = after;
        }
    }
    slope(t + step, now, k);
    for (std::size_t i = 0; i < y.size(); ++i) now[i] = 0.5 * (now[i] + before[i] + h * k[i]);
    return now;
}

/// y(t_end) from y(t), in `steps` steps of order 2 * columns.
inline Values extrapolate(const Slope& slope, double t, double t_end, Values y, int steps,
                          int columns = 7) {
    const double step = (t_end - t) / steps;
    for (int n = 0; n < steps; ++n) {
        std::vector<Values> row;  // of the tableau, from the right: row[j] has order 2 (k - j + 1)
        for (int k = 1; k <= columns; ++k) {
            std::vector<Values> next{midpoint_rule(slope, t + n * step, y, step, 2 * k)};
            for (int j = 1; j < k; ++j) {
                const double ratio = static_cast<double>(k) / (k - j);
                const Values &fine = next.back(), &coarse = row[static_cast<std::size_t>(j - 1)];
                Values better = fine;
                for (std::size_t i = 0; i < y.size(); ++i) {
                    better[i] += (fine[i] - coarse[i]) / (ratio * ratio - 1.0);
                }
                next.push_back(std::move(better));
            }
            row = std::move(next);
        }
        y = row.back();
    }
    return y;
}

}  // namespace weft::test
