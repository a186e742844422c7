#include "math/instruction_sets.h"

#include <fmt/format.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>

#include "weft/error.h"

namespace weft {

namespace {

constexpr std::array<std::string_view, 4> names{"scalar", "sse4", "avx2", "avx512"};

// The processor's sets come as a chain: one that has AVX-512 has AVX2 and SSE4 too.
std::size_t count_of_available() {
    const std::int64_t targets = hwy::SupportedTargets();
    std::size_t count = 1;
    if constexpr (HWY_ARCH_X86) {
        for (const std::int64_t target : {HWY_SSE4, HWY_AVX2, HWY_AVX3}) {
            if ((targets & target) == 0) break;
            ++count;
        }
    }
    return count;
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
