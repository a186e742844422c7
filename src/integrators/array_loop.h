// Loops over every component of a state's arrays: an integrator's update treats all alike.
#pragma once

#include "math/parallel.h"
#include "math/vec3_array.h"

namespace weft {

/// Calls body(begin, end) on ranges of [0, array.data_size()), in parallel where it pays.
template <typename Real, typename Body>
void for_components(const Vec3Array<Real>& array, const Body& body) {
    constexpr std::size_t grain = 65536;  // below this, waking a thread costs more than the loop
    parallel_for(array.data_size(), grain, body);
}

}  // namespace weft
