// The grid pass in float, compiled for every instruction set.
#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "forces/grid_pass_single.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "forces/grid_pass-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

void grid_pass_single(const GridPass<float>& pass, const GridBand<float>& band) {
    sweep(pass, band);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace weft {

GridPassFunction<float> grid_pass_single(InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, grid_pass_single);
}

}  // namespace weft
#endif
