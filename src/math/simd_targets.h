// Kernels are compiled once for each instruction set by including their own file again
// (hwy/foreach_target.h): this header says for which, and picks the compiled function at run time.
// Include it before hwy/foreach_target.h.
//
// The lowest set that Highway compiles for is its own emulation of vectors, where weft has scalar
// twins written to be read: kernels leave it out by `#if WEFT_SIMD_TARGET`.
#pragma once

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)

#include <hwy/detect_targets.h>

#include "math/instruction_sets.h"

#if HWY_ARCH_X86
#define WEFT_SIMD_TARGETS (HWY_SSE4 | HWY_AVX2 | HWY_AVX3)
#else
#define WEFT_SIMD_TARGETS 0
#endif
#define WEFT_SIMD_TARGET ((HWY_TARGET & WEFT_SIMD_TARGETS) != 0)

/// The function compiled for an instruction set; nullptr for scalar. Use where HWY_ONCE holds, in
/// the namespace around HWY_NAMESPACE.
#if HWY_ARCH_X86
#define WEFT_SIMD_FUNCTION(set, function)               \
    ((set) == InstructionSet::avx512 ? N_AVX3::function \
     : (set) == InstructionSet::avx2 ? N_AVX2::function \
     : (set) == InstructionSet::sse4 ? N_SSE4::function \
                                     : decltype(&N_SSE4::function){nullptr})
#else
#define WEFT_SIMD_FUNCTION(set, function) nullptr
#endif

namespace weft {

/// A kernel's reciprocal root is scaled by this: it saves an operation (math/simd-inl.h). Constants
/// that multiply a root are divided by it before.
template <typename Real>
inline constexpr Real root_scale = sizeof(Real) == 4 ? Real{2} : Real{1};

}  // namespace weft
