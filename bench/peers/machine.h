// What one thread of this machine can do at most: limits to hold every kernel against.
#pragma once

#include <cstddef>

namespace weft::bench {

/// Most multiply-adds a second in registers, each counted as two operations [GFLOP/s]. In theory
/// ports x lanes x 2 x clock.
double peak_single();
double peak_double();

/// Most bytes a second read plus written by a[i] = b * a[i] + c over an array of floats [GB/s].
/// @param bytes size of the array, so which level of the memory it stands in.
double update_bandwidth(std::size_t bytes);

/// Sizes of the first- and second-level data caches [bytes]; the usual 32 KiB and 1 MiB where the
/// system does not say.
std::size_t first_level_cache();
std::size_t second_level_cache();

}  // namespace weft::bench
