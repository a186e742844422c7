// What is measured on grids in double, compiled for every instruction set.
#include "math/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "forces/measure_grid_double.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "forces/measure_grid_shape-inl.h"
#include "forces/measure_grid_strain-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

using Real = double;
using View = ConstVec3View<Real>;

void grid_strain_double(const GridMeasure<Real>& grid, View x, View v, std::size_t begin,
                        std::size_t end, RatioRange<Real>* out) {
    measure_strain(grid, x, v, begin, end, out);
}
void grid_energy_double(const GridMeasure<Real>& grid, View x, View v, std::size_t begin,
                        std::size_t end, Energy* out) {
    measure_energy(grid, x, v, begin, end, out);
}
void grid_normals_double(const GridMeasure<Real>& grid, View x, std::size_t begin, std::size_t end,
                         Vec3f* out) {
    measure_normals(grid, x, begin, end, out);
}
void grid_copy_double(const GridMeasure<Real>& grid, View x, std::size_t begin, std::size_t end,
                      Vec3d* out) {
    measure_copy(grid, x, begin, end, out);
}
void grid_copy_rounded_double(const GridMeasure<Real>& grid, View x, std::size_t begin,
                              std::size_t end, Vec3f* out) {
    measure_copy_rounded(grid, x, begin, end, out);
}
std::uint64_t value_hash_double(const Real* values, std::size_t count, std::uint64_t key,
                                std::uint64_t key_step) {
    return measure_hash(values, count, key, key_step);
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace weft {

GridMeasures<double> grid_measures_double(InstructionSet set) {
    return {WEFT_SIMD_FUNCTION(set, grid_strain_double),
            WEFT_SIMD_FUNCTION(set, grid_energy_double),
            WEFT_SIMD_FUNCTION(set, grid_normals_double),
            WEFT_SIMD_FUNCTION(set, grid_copy_double),
            WEFT_SIMD_FUNCTION(set, grid_copy_rounded_double),
            WEFT_SIMD_FUNCTION(set, value_hash_double)};
}

}  // namespace weft
#endif
