// The order of convergence that a set of errors shows.
#pragma once

#include <cmath>
#include <vector>

namespace weft::test {

struct ErrorAtStep {
    double step = 0.0;
    double error = 0.0;
};

/// Least-squares slope of log(error) over log(step).
inline double fitted_order(const std::vector<ErrorAtStep>& errors) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const ErrorAtStep& e : errors) {
        const double lx = std::log(e.step), ly = std::log(e.error);
        n += 1;
        sx += lx;
        sy += ly;
        sxx += lx * lx;
        sxy += lx * ly;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace weft::test
