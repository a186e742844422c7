// Damage to a file: what transfer, editors and malice do to bytes, as a function of a number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/seeds.h"

namespace weft::fuzz {

/// One of the seeds with up to eight changes, always the same for the same number.
Seed damaged(const std::vector<Seed>& seeds, std::uint64_t number);

}  // namespace weft::fuzz
