// The mesh pass in float, compiled for every instruction set.
#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "forces/mesh_pass_single.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "forces/mesh_pass-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

void copy_rows_single(const MeshPass<float>& pass, std::size_t begin, std::size_t end) {
    copy_rows(pass, begin, end);
}
void find_thirds_single(const MeshPass<float>& pass, std::size_t begin, std::size_t end) {
    find_thirds(pass, begin, end);
}
void sum_and_move_single(const MeshPass<float>& pass, std::size_t begin, std::size_t end) {
    sum_and_move(pass, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace weft {

MeshPassFunctions<float> mesh_pass_single(InstructionSet set) {
    return {WEFT_SIMD_FUNCTION(set, copy_rows_single), WEFT_SIMD_FUNCTION(set, find_thirds_single),
            WEFT_SIMD_FUNCTION(set, sum_and_move_single)};
}

}  // namespace weft
#endif
