// The linear passes in float, compiled for every instruction set.
#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "forces/linear_pass_single.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "forces/linear_mesh_pass-inl.h"
#include "forces/linear_pass-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

void linear_grid_single(const LinearGridPass<float>& pass, const LinearBand<float>& band) {
    linear_sweep(pass, band);
}

LinearSums linear_mesh_single(const LinearMeshPass<float>& pass, std::size_t begin,
                              std::size_t end) {
    return linear_slices(pass, begin, end);
}

void linear_records_single(const LinearRecords<float>& from, std::size_t begin, std::size_t end) {
    write_records(from, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace weft {

LinearGridFunction<float> linear_grid_single(InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, linear_grid_single);
}

LinearMeshFunction<float> linear_mesh_single(InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, linear_mesh_single);
}

LinearRecordsFunction<float> linear_records_single(InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, linear_records_single);
}

}  // namespace weft
#endif
