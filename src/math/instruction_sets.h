// The instruction sets that kernels are compiled for, and the one in use.
#pragma once

#include <string_view>

#include "weft/instruction_set.h"

namespace weft {

/// In the order of instruction_sets(): a later set includes the earlier ones.
enum class InstructionSet { scalar, sse4, avx2, avx512 };

std::string_view name_of(InstructionSet set);

/// The one that instruction_set() names.
InstructionSet chosen_instruction_set();

}  // namespace weft
