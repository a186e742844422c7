#include "forces/measure_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "math/parallel.h"

namespace weft {

namespace {

// What is worth a thread of its own.
constexpr std::size_t block_grain = 32;
constexpr std::size_t particle_grain = 8192;

template <typename Real>
Vec3d along(ConstVec3View<Real> a, std::size_t slot_p, std::size_t slot_q) {
    return vec3_cast<double>(a[slot_q]) - vec3_cast<double>(a[slot_p]);
}

// The numbers below `count` by rising key(n) < keys; equal ones in their order.
template <typename Key>
std::vector<std::uint32_t> sorted(std::size_t count, std::size_t keys, const Key& key) {
    std::vector<std::uint32_t> next(keys + 1, 0), order(count);
    for (std::size_t n = 0; n < count; ++n) ++next[key(n) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (std::size_t n = 0; n < count; ++n) {
        order[next[key(n)]++] = static_cast<std::uint32_t>(n);
    }
    return order;
}

}  // namespace

template <typename Real>
MeshMeasures<Real>::MeshMeasures(const ClothModel& cloth) : cloth_(cloth) {
    if (cloth.is_grid()) return;
    particles_.resize(cloth.layout.slot_count());
    cloth.layout.for_each(
        [&](std::size_t p, std::size_t slot) { particles_[slot] = static_cast<std::uint32_t>(p); });
    list_springs();
    list_triangles();
}

template <typename Real>
void MeshMeasures<Real>::list_springs() {
    const std::vector<std::uint32_t> order =
        sorted(cloth_.springs.size(), particles_.size(), [&](std::size_t n) {
            const Spring& spring = cloth_.springs[n];
            return std::min(cloth_.slot(spring.p), cloth_.slot(spring.q));
        });
    reaches_.reserve(order.size());
    stores_.reserve(order.size());
    kinds_.reserve(order.size());
    const bool per_width = cloth_.stiffness_per == StiffnessPer::width;
    for (const std::uint32_t n : order) {
        const Spring& spring = cloth_.springs[n];
        const double length = spring.rest_length;
        const double stiffness = cloth_.materials[static_cast<std::size_t>(spring.kind)].stiffness;
        reaches_.push_back({static_cast<std::uint32_t>(cloth_.slot(spring.p)),
                            static_cast<std::uint32_t>(cloth_.slot(spring.q)),
                            static_cast<Real>(1.0 / (length * length))});
        stores_.push_back({length, 0.5 * stiffness * (per_width ? spring.width_factor : 1.0)});
        kinds_.push_back(spring.kind);
    }
}

// Triangles stand by their lowest slot, but every particle adds its own in the surface's order.
template <typename Real>
void MeshMeasures<Real>::list_triangles() {
    const Surface& surface = cloth_.surface;
    const std::size_t count = surface.triangles.size();
    const auto slots = [&](std::size_t t) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t n = 0; n < 3; ++n) {
            const std::size_t particle = surface.particle(surface.triangles[t][n]);
            corners[n] = static_cast<std::uint32_t>(cloth_.slot(particle));
        }
        return corners;
    };
    const std::vector<std::uint32_t> order =
        sorted(count, particles_.size(), [&](std::size_t t) -> std::size_t {
            const auto corners = slots(t);
            return std::min({corners[0], corners[1], corners[2]});
        });
    std::vector<std::uint32_t> place(count);
    triangles_.reserve(count);
    first_around_.assign(particles_.size() + 1, 0);
    for (const std::uint32_t t : order) {
        place[t] = static_cast<std::uint32_t>(triangles_.size());
        triangles_.push_back(slots(t));
        for (const std::uint32_t slot : triangles_.back()) ++first_around_[slot + 1];
    }
    std::partial_sum(first_around_.begin(), first_around_.end(), first_around_.begin());
    around_.resize(first_around_.back());
    std::vector<std::uint32_t> next(first_around_.begin(), first_around_.end() - 1);
    for (std::size_t t = 0; t < count; ++t) {
        for (const std::uint32_t slot : triangles_[place[t]]) around_[next[slot]++] = place[t];
    }
    twice_areas_.resize(count);
}

// Numbers that are not negative compare as their bits do, in fewer cycles; NaN is beyond all.
template <typename Real>
void MeshMeasures<Real>::strain(View x, std::span<RatioRange<Real>> out) const {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    parallel_for(block_count(), block_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            Bits smallest = std::bit_cast<Bits>(Real{1}), largest = smallest;
            for (std::size_t n = b * block_size; n < end_of(b); ++n) {
                const Reach& spring = reaches_[n];
                const Vec3<Real> d = x[spring.q] - x[spring.p];
                const auto ratio = std::bit_cast<Bits>(dot(d, d) * spring.inverse_square);
                smallest = std::min(smallest, ratio);
                largest = std::max(largest, ratio);
            }
            out[b] = {std::bit_cast<Real>(smallest), std::bit_cast<Real>(largest)};
        }
    });
}

template <typename Real>
SpringStrain MeshMeasures<Real>::largest_strain(View x, std::size_t block) const {
    SpringStrain largest;
    for (std::size_t n = block * block_size; n < end_of(block); ++n) {
        const auto [p, q, inverse_square] = reaches_[n];
        const double strain = length(along(x, p, q)) / stores_[n].rest_length - 1.0;
        if (std::abs(strain) <= std::abs(largest.strain)) continue;
        const auto [first, second] = std::minmax({particles_[p], particles_[q]});
        largest = {strain, first, second, spring_kind_names[static_cast<std::size_t>(kinds_[n])]};
    }
    return largest;
}

template <typename Real>
Energy MeshMeasures<Real>::energy_of_block(View x, std::size_t block) const {
    std::array<double, 3> sums{};  // by kind
    for (std::size_t n = block * block_size; n < end_of(block); ++n) {
        const double stretch =
            length(along(x, reaches_[n].p, reaches_[n].q)) - stores_[n].rest_length;
        sums[static_cast<std::size_t>(kinds_[n])] += stores_[n].stiffness * stretch * stretch;
    }
    return {0.0, 0.0, sums[0], sums[1], sums[2]};
}

template <typename Real>
void MeshMeasures<Real>::energy(View x, std::span<Energy> out) const {
    parallel_for(block_count(), block_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) out[b] = energy_of_block(x, b);
    });
}

template <typename Real>
void MeshMeasures<Real>::normals(View x, std::span<Vec3f> out) {
    parallel_for(triangles_.size(), particle_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const auto [a, b, c] = triangles_[t];
            const Vec3<Real> origin = x[a];
            twice_areas_[t] = cross(x[b] - origin, x[c] - origin);
        }
    });
    parallel_for(particles_.size(), particle_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            Vec3<Real> sum{};
            for (std::size_t n = first_around_[slot]; n < first_around_[slot + 1]; ++n) {
                sum += twice_areas_[around_[n]];
            }
            const Real norm = length(sum);
            const Real inverse = norm > 0 ? 1 / norm : Real{0};
            out[particles_[slot]] = vec3_cast<float>(inverse * sum);
        }
    });
}

template <typename Real>
template <typename To>
void MeshMeasures<Real>::copy_as(View x, std::span<Vec3<To>> out) const {
    parallel_for(particles_.size(), particle_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            out[particles_[slot]] = vec3_cast<To>(x[slot]);
        }
    });
}

template <typename Real>
void MeshMeasures<Real>::copy(View x, std::span<Vec3d> out) const {
    copy_as(x, out);
}

template <typename Real>
void MeshMeasures<Real>::copy(View x, std::span<Vec3f> out) const {
    copy_as(x, out);
}

template class MeshMeasures<float>;
template class MeshMeasures<double>;

}  // namespace weft
