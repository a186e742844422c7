// Forces of a cloth as plain vectors, and their sums.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "forces/grid_air.h"
#include "forces/grid_springs.h"
#include "forces/mesh_air.h"
#include "forces/mesh_springs.h"
#include "support/cloth_scenes.h"

namespace weft::test {

/// An array of a state or of forces, [slot], as vectors by [particle].
template <typename Real>
std::vector<Vec3d> as_vectors(const ClothModel& cloth, const Vec3Array<Real>& array) {
    std::vector<Vec3d> vectors;
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        vectors.push_back(vec3_cast<double>(array[cloth.slot(p)]));
    }
    return vectors;
}

/// The spring kernel that fits the cloth, on all of it; [slot].
template <typename Real>
Vec3Array<Real> spring_forces(const ClothModel& cloth, const ParticleState<Real>& state) {
    Vec3Array<Real> f(cloth.layout.slot_count());
    if (cloth.is_grid()) {
        GridSprings<Real>(cloth).add_forces(state.x.view(), state.v.view(), f.view(), 0,
                                            cloth.shape.rows);
    } else {
        MeshSprings<Real>(cloth).add_forces(state.x.view(), state.v.view(), f.view(), 0,
                                            cloth.layout.slot_count());
    }
    return f;
}

/// The forces of the air on all of a cloth, [particle], by the kernel for meshes.
template <typename Real>
std::vector<Vec3d> mesh_air_forces(const WindDescription& wind, const ClothModel& cloth,
                                   Vec3d velocity, const ParticleState<Real>& state) {
    MeshAir<Real> air(wind, cloth.surface, cloth.layout);
    Vec3Array<Real> f(state.x.size());
    air.compute(vec3_cast<Real>(velocity), state.x.view(), state.v.view(), 0, air.triangle_count());
    air.add_forces(f.view(), 0, state.x.size());
    return as_vectors(cloth, f);
}

/// The same by the kernel for grids.
template <typename Real>
std::vector<Vec3d> grid_air_forces(const WindDescription& wind, const ClothModel& cloth,
                                   Vec3d velocity, const ParticleState<Real>& state) {
    Vec3Array<Real> f(state.x.size());
    GridAir<Real>(wind, cloth.shape, cloth.layout.row_stride())
        .add_forces(vec3_cast<Real>(velocity), state.x.view(), state.v.view(), f.view(), 0,
                    cloth.shape.rows);
    return as_vectors(cloth, f);
}

inline Vec3d sum_of(const std::vector<Vec3d>& vectors) {
    Vec3d sum{};
    for (const Vec3d v : vectors) sum += v;
    return sum;
}

inline Vec3d torque_of(const std::vector<Vec3d>& x, const std::vector<Vec3d>& f) {
    Vec3d sum{};
    for (std::size_t p = 0; p < x.size(); ++p) sum += cross(x[p], f[p]);
    return sum;
}

inline double largest(const std::vector<Vec3d>& vectors) {
    double size = 0.0;
    for (const Vec3d v : vectors) size = std::max(size, length(v));
    return size;
}

inline double largest_difference(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
    double difference = a.size() == b.size() ? 0.0 : 1e300;
    for (std::size_t p = 0; p < a.size() && p < b.size(); ++p) {
        difference = std::max(difference, length(a[p] - b[p]));
    }
    return difference;
}

/// How many components differ in a bit, in padding too; -0 and 0 differ.
template <typename Real>
std::size_t different_bits(const Vec3Array<Real>& a, const Vec3Array<Real>& b) {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    std::size_t count = 0;
    for (std::size_t p = 0; p < a.size(); ++p) {
        const Vec3<Real> u = a[p], v = b[p];
        count += std::bit_cast<Bits>(u.x) != std::bit_cast<Bits>(v.x);
        count += std::bit_cast<Bits>(u.y) != std::bit_cast<Bits>(v.y);
        count += std::bit_cast<Bits>(u.z) != std::bit_cast<Bits>(v.z);
    }
    return count;
}

}  // namespace weft::test
