// The linear passes in double, compiled for every instruction set.
#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "forces/linear_pass_double.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "forces/linear_mesh_pass-inl.h"
#include "forces/linear_pass-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

void linear_grid_double(const LinearGridPass<double>& pass, const LinearBand<double>& band) {
    linear_sweep(pass, band);
}

LinearSums linear_mesh_double(const LinearMeshPass<double>& pass, std::size_t begin,
                              std::size_t end) {
    return linear_slices(pass, begin, end);
}

void linear_records_double(const LinearRecords<double>& from, std::size_t begin, std::size_t end) {
    write_records(from, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace weft {

LinearGridFunction<double> linear_grid_double(InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, linear_grid_double);
}

LinearMeshFunction<double> linear_mesh_double(InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, linear_mesh_double);
}

LinearRecordsFunction<double> linear_records_double(InstructionSet set) {
    return WEFT_SIMD_FUNCTION(set, linear_records_double);
}

}  // namespace weft
#endif
