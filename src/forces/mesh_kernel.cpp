#include "forces/mesh_kernel.h"

#include <algorithm>
#include <cassert>

#include "math/parallel.h"
#include "math/simd_targets.h"

namespace weft {

namespace {

// Particles worth a thread of their own: fewer take as long as waking the thread.
constexpr std::size_t part_grain = 8192;

template <typename Real>
std::array<Real*, 3> components(Vec3View<Real> view) {
    return {view.x, view.y, view.z};
}

// A pass reads x and v through the pointers that others move them by.
template <typename Real>
Vec3View<Real> writable(ConstVec3View<Real> view) {
    return {const_cast<Real*>(view.x), const_cast<Real*>(view.y), const_cast<Real*>(view.z),
            view.size};
}

}  // namespace

template <typename Real>
MeshKernel<Real>::MeshKernel(const ClothModel& cloth, const ForcesDescription& forces,
                             const std::optional<WindDescription>& wind,
                             std::span<const Real> inverse_masses, InstructionSet set, int threads)
    : lanes_(mesh_lanes<Real>(set)), springs_(cloth, lanes_) {
    const std::size_t slots = cloth.layout.slot_count();
    assert(set != InstructionSet::scalar && inverse_masses.size() == slots);
    if constexpr (sizeof(Real) == 4) {
        functions_ = mesh_pass_single(set);
    } else {
        functions_ = mesh_pass_double(set);
    }
    if (wind) triangles_ = MeshTriangleTables(cloth, lanes_);
    pass_.slices = (slots + lanes_ - 1) / lanes_;
    inverse_masses_ = LineAligned<Real>(pass_.slices * lanes_);
    std::copy(inverse_masses.begin(), inverse_masses.end(), inverse_masses_.data());
    const std::size_t most = std::max<std::size_t>(slots / part_grain, 1);
    parts_ = std::min(static_cast<std::size_t>(std::max(threads, 1)), most);
    constexpr double square_scale = double{root_scale<Real>} * double{root_scale<Real>};
    for (std::size_t kind = 0; kind < spring_kind_count; ++kind) {
        pass_.springs[kind] = {static_cast<Real>(cloth.materials[kind].stiffness),
                               static_cast<Real>(cloth.materials[kind].damping / square_scale)};
    }
    pass_.drag = static_cast<Real>(forces.damping);
    pass_.gravity = vec3_cast<Real>(forces.gravity);
    pass_.air = wind.has_value();
    if (wind) pass_.air_constants = AirConstants<Real>(*wind);
    set_tables();
}

template <typename Real>
void MeshKernel<Real>::set_tables() {
    rows_ = LineAligned<Real>(pass_.slices * lanes_ * MeshPass<Real>::row_size);
    pass_.rows = rows_.data();
    pass_.spring_starts = springs_.neighbours.starts.data();
    pass_.neighbours = springs_.neighbours.items.data();
    pass_.tensions = springs_.tensions.data();
    if (springs_.widths.size() > 0) pass_.widths = springs_.widths.data();
    pass_.inverse_masses = inverse_masses_.data();
    if (!pass_.air) return;
    thirds_ = LineAligned<Real>(triangles_.vectors * lanes_ * MeshPass<Real>::third_size);
    pass_.thirds = thirds_.data();
    pass_.triangle_vectors = triangles_.vectors;
    pass_.corners = triangles_.corners.data();
    pass_.triangle_starts = triangles_.triangles.starts.data();
    pass_.triangles = triangles_.triangles.items.data();
}

template <typename Real>
void MeshKernel<Real>::run_part(MeshPassFunction<Real> function, std::size_t vectors) {
    parallel_for(parts_, 1, [&](std::size_t begin, std::size_t end) {
        function(pass_, begin * vectors / parts_, end * vectors / parts_);
    });
}

template <typename Real>
void MeshKernel<Real>::run(Vec3<Real> wind, Vec3View<Real> x, Vec3View<Real> v) {
    pass_.wind = wind;
    pass_.x = components(x);
    pass_.v = components(v);
    run_part(functions_.copy_rows, pass_.slices);
    if (pass_.air) run_part(functions_.find_thirds, pass_.triangle_vectors);
    run_part(functions_.sum_and_move, pass_.slices);
}

template <typename Real>
void MeshKernel<Real>::accelerate(Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v,
                                  Vec3View<Real> a) {
    pass_.update = MeshUpdate::acceleration;
    pass_.a = components(a);
    run(wind, writable(x), writable(v));
}

template <typename Real>
void MeshKernel<Real>::kick_drift(Vec3<Real> wind, double kick, double drift, Vec3View<Real> x,
                                  Vec3View<Real> v) {
    pass_.update = MeshUpdate::kick_drift;
    pass_.kick = static_cast<Real>(kick);
    pass_.drift = static_cast<Real>(drift);
    run(wind, x, v);
}

template class MeshKernel<float>;
template class MeshKernel<double>;

}  // namespace weft
