// The middle of several timings.
#pragma once

#include <vector>

namespace weft::bench {

/// @pre at least one value.
double median(std::vector<double> values);

}  // namespace weft::bench
