#include "math/instruction_sets.h"

#include <fmt/format.h>
#include <hwy/detect_compiler_arch.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>

#include "weft/error.h"

namespace weft {

namespace {

constexpr std::array<std::string_view, 4> names{"scalar", "sse4", "avx2", "avx512"};

// The processor's sets come as a chain: one that has AVX-512 has AVX2 and SSE4 too. What Highway's
// targets use of each; its own question at run time would cost 3 ms at every start.
std::size_t count_of_available() {
#if HWY_ARCH_X86
    const bool sse4 = __builtin_cpu_supports("sse4.1") && __builtin_cpu_supports("ssse3") &&
                      __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
    const bool avx2 = sse4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") &&
                        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                        __builtin_cpu_supports("avx512bw");
    return avx512 ? 4 : avx2 ? 3 : sse4 ? 2 : 1;
#else
    return 1;
#endif
}

InstructionSet find(std::string_view name, const std::string& place) {
    const auto available = instruction_sets();
    const auto found = std::find(available.begin(), available.end(), name);
    if (found == available.end()) {
        std::string known;
        for (const std::string_view set : available) {
            known += (known.empty() ? "" : ", ") + std::string(set);
        }
        throw Error(ErrorKind::usage, {.key = place},
                    fmt::format("\"{}\" is not an instruction set of this machine: it has {}", name,
                                known));
    }
    return static_cast<InstructionSet>(found - available.begin());
}

InstructionSet first_choice() {
    const char* wanted = std::getenv("WEFT_SIMD");
    if (wanted != nullptr && *wanted != '\0') return find(wanted, "environment variable WEFT_SIMD");
    return static_cast<InstructionSet>(instruction_sets().size() - 1);
}

std::atomic<InstructionSet>& choice() {
    static std::atomic<InstructionSet> set = first_choice();
    return set;
}

}  // namespace

std::string_view name_of(InstructionSet set) {
    return names[static_cast<std::size_t>(set)];
}

InstructionSet chosen_instruction_set() {
    return choice();
}

std::span<const std::string_view> instruction_sets() {
    static const std::size_t count = count_of_available();
    return {names.data(), count};
}

std::string_view instruction_set() {
    return name_of(choice());
}

void use_instruction_set(std::string_view name) {
    const InstructionSet set = find(name, "--simd");
    choice() = set;
}

}  // namespace weft
