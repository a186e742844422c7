// Random numbers without state: each is a function of its key, so that it does not matter who asks
// first. The mixing function is SplitMix64 (Steele, Lea, Flood 2014), whose constants are facts.
#pragma once

#include <cstdint>

namespace weft {

constexpr std::uint64_t mix_bits(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// Uniform in [0, 1), a function of (seed, stream, counter).
constexpr double random_uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
    const std::uint64_t bits = mix_bits(mix_bits(mix_bits(seed) ^ stream) ^ counter);
    return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}  // namespace weft
