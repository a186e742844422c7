#include "lab/work_precision/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace weft::lab {

std::vector<std::size_t> pareto_front(std::span<const CostAndError> points) {
    std::vector<std::size_t> order;
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (std::isfinite(points[n].cost) && std::isfinite(points[n].error)) order.push_back(n);
    }
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return std::tuple(points[a].cost, points[a].error, a) <
               std::tuple(points[b].cost, points[b].error, b);
    });
    double least = std::numeric_limits<double>::infinity();
    std::vector<std::size_t> front;
    for (const std::size_t n : order) {
        if (points[n].error >= least) continue;
        least = points[n].error;
        front.push_back(n);
    }
    return front;
}

}  // namespace weft::lab
