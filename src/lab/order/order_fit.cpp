#include "lab/order/order_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace weft::lab {

namespace {

using Points = std::span<const ErrorAtStep>;

double slope_between(const ErrorAtStep& a, const ErrorAtStep& b) {
    return std::log(a.error / b.error) / std::log(a.step / b.step);
}

double least_squares_slope(Points points) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const ErrorAtStep& point : points) {
        const double x = std::log(point.step), y = std::log(point.error);
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// How many points before `end` are straight together.
std::size_t straight_before(Points points, std::size_t end) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    std::size_t count = 1;
    while (count < end) {
        const double slope = slope_between(points[end - count - 1], points[end - count]);
        low = std::min(low, slope);
        high = std::max(high, slope);
        if (high - low > straight_within) break;
        ++count;
    }
    return count;
}

OrderFit fit(Points points, bool straight) {
    return {least_squares_slope(points), points.back().step, points.front().step, points.size(),
            straight};
}

}  // namespace

std::string OrderFit::range() const {
    if (points == 0) return "no two errors above the reference's";
    return fmt::format("{:.1e} to {:.1e} s", smallest, largest);
}

OrderFit fit_order(Points errors, double floor) {
    std::vector<ErrorAtStep> usable;
    for (const ErrorAtStep& point : errors) {
        if (std::isfinite(point.error) && point.error > std::max(floor, 0.0)) {
            usable.push_back(point);
        }
    }
    for (const std::size_t least : {4u, 3u}) {
        for (std::size_t end = usable.size(); end >= least; --end) {
            const std::size_t count = straight_before(usable, end);
            if (count >= least) return fit(Points(usable).subspan(end - count, count), true);
        }
    }
    if (usable.size() >= 2) return fit(usable, false);
    OrderFit none;
    none.order = std::numeric_limits<double>::quiet_NaN();
    return none;
}

}  // namespace weft::lab
