// The kernels of forces/newton_pass.h, compiled for every instruction set.
#include "forces/newton_pass.h"

#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "forces/newton_pass.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "forces/newton_pass-inl.h"
#include "forces/newton_pass_factor-inl.h"
#include "forces/newton_pass_transfer-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

using Field = NewtonKernels::Field;
using ConstField = NewtonKernels::ConstField;

void newton_product(const NewtonGrid& grid, const NewtonBand& band, ConstField u, Field out,
                    double* sums) {
    newton_sweep<NewtonUpdate::product>(grid, band, {u, u, out}, sums);
}

void newton_residual(const NewtonGrid& grid, const NewtonBand& band, ConstField u, ConstField b,
                     Field out) {
    newton_sweep<NewtonUpdate::residual>(grid, band, {u, b, out}, nullptr);
}

void newton_smooth(const NewtonGrid& grid, const NewtonBand& band, float omega, ConstField u,
                   ConstField b, Field out, double* sums) {
    newton_sweep<NewtonUpdate::smooth>(grid, band, {u, b, out, omega}, sums);
}

void newton_first(const NewtonGrid& grid, const NewtonBand& band, float omega, ConstField b,
                  Field out) {
    newton_start(grid, band, omega, b, out);
}

const NewtonKernels* newton_table() {
    static constexpr NewtonKernels kernels{
        newton_factor,  newton_product,     newton_residual, newton_smooth,  newton_first,
        newton_coarsen, newton_interpolate, newton_narrow,   newton_advance, newton_turn};
    return &kernels;
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace weft {

const NewtonKernels& newton_kernels(InstructionSet set) {
    const auto table = WEFT_SIMD_FUNCTION(set, newton_table);
    return table == nullptr ? newton_twins : *table();
}

}  // namespace weft
#endif
