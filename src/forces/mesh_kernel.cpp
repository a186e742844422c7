#include "forces/mesh_kernel.h"

#include <algorithm>
#include <cassert>

#include "math/parallel.h"
#include "math/simd_targets.h"

namespace weft {

namespace {

// Particles worth a thread of their own: fewer take as long as waking the thread.
constexpr std::size_t part_grain = 8192;

// Slots whose rows and triangles stay in the first-level cache until they are read.
constexpr std::size_t chunk_slots = 1024;

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
    const std::size_t most = std::max<std::size_t>(slots / part_grain, 1);
    parts_ = std::min(static_cast<std::size_t>(std::max(threads, 1)), most);
    if (wind) triangles_ = MeshTriangleTables(cloth, lanes_);
    // Several threads take the whole mesh in one chunk: a part's neighbours may be anyone's.
    const std::size_t slices = (slots + lanes_ - 1) / lanes_;
    schedule_ = MeshSchedule(springs_.neighbours, triangles_, slices,
                             parts_ > 1 ? slices : chunk_slots / lanes_, lanes_);
    inverse_masses_ = LineAligned<Real>(slices * lanes_);
    std::copy(inverse_masses.begin(), inverse_masses.end(), inverse_masses_.data());
    set_constants(cloth, forces, wind);
    set_tables();
}

template <typename Real>
void MeshKernel<Real>::set_constants(const ClothModel& cloth, const ForcesDescription& forces,
                                     const std::optional<WindDescription>& wind) {
    constexpr double square_scale = double{root_scale<Real>} * double{root_scale<Real>};
    for (std::size_t kind = 0; kind < spring_kind_count; ++kind) {
        pass_.springs[kind] = {static_cast<Real>(cloth.materials[kind].stiffness),
                               static_cast<Real>(cloth.materials[kind].damping / square_scale)};
    }
    pass_.drag = static_cast<Real>(forces.damping);
    pass_.gravity = vec3_cast<Real>(forces.gravity);
    pass_.air = wind.has_value();
    if (wind) pass_.air_constants = AirConstants<Real>(*wind);
}

template <typename Real>
void MeshKernel<Real>::set_tables() {
    constexpr std::size_t row_size = MeshPass<Real>::row_size;
    constexpr std::size_t third_size = MeshPass<Real>::third_size;
    const std::size_t rows = schedule_.rows, thirds = schedule_.thirds;
    const auto to_places = [](LineAligned<std::uint32_t>& items, const auto& place) {
        for (std::size_t n = 0; n < items.size(); ++n) {
            items[n] = static_cast<std::uint32_t>(place(items[n]));
        }
    };
    const auto row_place = [&](std::uint32_t slot) { return (slot & (rows - 1)) * row_size; };
    rows_ = LineAligned<Real>(std::min(rows, inverse_masses_.size()) * row_size);
    pass_.rows = rows_.data();
    pass_.row_mask = rows - 1;
    to_places(springs_.neighbours.items, row_place);
    pass_.spring_starts = springs_.neighbours.starts.data();
    pass_.neighbours = springs_.neighbours.items.data();
    pass_.tensions = springs_.tensions.data();
    if (springs_.widths.size() > 0) pass_.widths = springs_.widths.data();
    pass_.inverse_masses = inverse_masses_.data();
    if (!pass_.air) return;
    thirds_ = LineAligned<Real>((thirds + 1) * third_size);
    pass_.thirds = thirds_.data();
    pass_.third_mask = thirds - 1;
    to_places(triangles_.corners, row_place);
    to_places(triangles_.triangles.items, [&](std::uint32_t triangle) {
        const bool padding = triangle == MeshTriangleTables::none;
        return (padding ? thirds : triangle & (thirds - 1)) * third_size;
    });
    pass_.corners = triangles_.corners.data();
    pass_.triangle_starts = triangles_.triangles.starts.data();
    pass_.triangles = triangles_.triangles.items.data();
}

template <typename Real>
void MeshKernel<Real>::run_part(MeshPassFunction<Real> function, std::size_t begin,
                                std::size_t end) const {
    const std::size_t count = end - begin;
    parallel_for(parts_, 1, [&](std::size_t first, std::size_t last) {
        function(pass_, begin + first * count / parts_, begin + last * count / parts_);
    });
}

template <typename Real>
void MeshKernel<Real>::run(Vec3<Real> wind, Vec3View<Real> x, Vec3View<Real> v) {
    pass_.wind = wind;
    pass_.x = components(x);
    pass_.v = components(v);
    MeshChunk done;
    for (const MeshChunk& chunk : schedule_.chunks) {
        run_part(functions_.copy_rows, done.slices_copied, chunk.slices_copied);
        if (pass_.air) {
            run_part(functions_.find_thirds, done.triangle_vectors, chunk.triangle_vectors);
        }
        run_part(functions_.sum_and_move, done.slices_moved, chunk.slices_moved);
        done = chunk;
    }
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
