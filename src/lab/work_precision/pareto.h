// What is not beaten by anything else in both cost and error.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace weft::lab {

struct CostAndError {
    double cost = 0.0, error = 0.0;
};

/// Places of the points that no other point equals or beats in both: by rising cost, falling error.
/// Points with a cost or an error that is not finite are never among them; of equal ones the first.
std::vector<std::size_t> pareto_front(std::span<const CostAndError> points);

}  // namespace weft::lab
