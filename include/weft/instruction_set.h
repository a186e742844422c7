// Which vector instructions the kernels use.
#pragma once

#include <span>
#include <string_view>

namespace weft {

/// The sets that this machine can run, of "scalar", "sse4", "avx2", "avx512", in this order.
/// "scalar" is the readable twin of every kernel: the same bits on every machine. The others use
/// fused multiply-adds and approximate reciprocal roots, refined to the precision of the run.
std::span<const std::string_view> instruction_sets();

/// The set that simulations made from now on use: the environment variable WEFT_SIMD, or the last
/// of instruction_sets().
/// @throws Error (usage) where WEFT_SIMD names none of instruction_sets().
std::string_view instruction_set();

/// Chooses the set for simulations made from now on, in the whole process.
/// @throws Error (usage) where `name` is none of instruction_sets().
void use_instruction_set(std::string_view name);

}  // namespace weft
