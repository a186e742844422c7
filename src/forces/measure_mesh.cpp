#include "forces/measure_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/parallel.h"

namespace weft {

namespace {

constexpr std::size_t block_size = 512;  // springs
// What is worth a thread of its own.
constexpr std::size_t block_grain = 32;
constexpr std::size_t particle_grain = 8192;

template <typename Real>
Vec3d along(ConstVec3View<Real> a, std::size_t slot_p, std::size_t slot_q) {
    return vec3_cast<double>(a[slot_q]) - vec3_cast<double>(a[slot_p]);
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
    springs_.reserve(cloth_.springs.size());
    for (const Spring& spring : cloth_.springs) {
        const double square = spring.rest_length * spring.rest_length;
        const auto [low, high] = std::minmax(cloth_.slot(spring.p), cloth_.slot(spring.q));
        springs_.push_back({static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high),
                            static_cast<Real>(1.0 / square),
                            static_cast<std::uint32_t>(springs_.size())});
    }
    const auto kind_of = [&](const MeasuredSpring& spring) {
        return cloth_.springs[spring.number].kind;
    };
    std::sort(springs_.begin(), springs_.end(),
              [&](const MeasuredSpring& a, const MeasuredSpring& b) {
                  if (kind_of(a) != kind_of(b)) return kind_of(a) < kind_of(b);
                  if (a.p != b.p) return a.p < b.p;
                  return a.q != b.q ? a.q < b.q : a.number < b.number;
              });
    for (std::size_t begin = 0, end = 0; begin < springs_.size(); begin = end) {
        const SpringKind kind = kind_of(springs_[begin]);
        while (end < springs_.size() && end - begin < block_size && kind_of(springs_[end]) == kind)
            ++end;
        blocks_.push_back({begin, end, kind});
    }
}

// Triangles stand by their lowest slot, but every particle adds its own in the surface's order.
template <typename Real>
void MeshMeasures<Real>::list_triangles() {
    const Surface& surface = cloth_.surface;
    const std::size_t count = surface.triangles.size();
    std::vector<std::array<std::uint32_t, 3>> slots(count);
    for (std::size_t t = 0; t < count; ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t particle = surface.particle(surface.triangles[t][corner]);
            slots[t][corner] = static_cast<std::uint32_t>(cloth_.slot(particle));
        }
    }
    std::vector<std::uint32_t> order(count), place(count);
    std::iota(order.begin(), order.end(), 0U);
    const auto lowest = [&](std::uint32_t t) { return *std::ranges::min_element(slots[t]); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return lowest(a) != lowest(b) ? lowest(a) < lowest(b) : a < b;
    });
    for (const std::uint32_t t : order) {
        place[t] = static_cast<std::uint32_t>(triangles_.size());
        triangles_.push_back(slots[t]);
    }
    first_around_.assign(particles_.size() + 1, 0);
    for (const auto& triangle : slots) {
        for (const std::uint32_t slot : triangle) ++first_around_[slot + 1];
    }
    std::partial_sum(first_around_.begin(), first_around_.end(), first_around_.begin());
    around_.resize(first_around_.back());
    std::vector<std::uint32_t> next(first_around_.begin(), first_around_.end() - 1);
    for (std::size_t t = 0; t < count; ++t) {
        for (const std::uint32_t slot : slots[t]) around_[next[slot]++] = place[t];
    }
    twice_areas_.resize(count);
}

template <typename Real>
void MeshMeasures<Real>::strain(View x, std::span<RatioRange<Real>> out) const {
    parallel_for(blocks_.size(), block_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            Real smallest = 1, largest = 1;
            for (std::size_t n = blocks_[b].begin; n < blocks_[b].end; ++n) {
                const MeasuredSpring& spring = springs_[n];
                const Vec3<Real> d = x[spring.q] - x[spring.p];
                const Real ratio = dot(d, d) * spring.inverse_square;
                smallest = ratio < smallest ? ratio : smallest;
                largest = ratio > largest ? ratio : largest;
            }
            out[b] = {smallest, largest};
        }
    });
}

template <typename Real>
SpringStrain MeshMeasures<Real>::largest_strain(View x, std::size_t block) const {
    SpringStrain largest;
    std::size_t number = springs_.size();
    for (std::size_t n = blocks_[block].begin; n < blocks_[block].end; ++n) {
        const MeasuredSpring& measured = springs_[n];
        const Spring& spring = cloth_.springs[measured.number];
        const Vec3d d = along(x, cloth_.slot(spring.p), cloth_.slot(spring.q));
        const double strain = length(d) / spring.rest_length - 1.0;
        const double difference = std::abs(strain) - std::abs(largest.strain);
        // Of equal ones the first, as in the twin.
        if (difference < 0 || (difference == 0 && measured.number > number)) continue;
        number = measured.number;
        largest = {strain, spring.p, spring.q,
                   spring_kind_names[static_cast<std::size_t>(spring.kind)]};
    }
    return largest;
}

template <typename Real>
double MeshMeasures<Real>::stored(View x, const MeasuredSpring& measured) const {
    const Spring& spring = cloth_.springs[measured.number];
    const double factor = cloth_.stiffness_per == StiffnessPer::width ? spring.width_factor : 1.0;
    const double stretch = length(along(x, measured.p, measured.q)) - spring.rest_length;
    return factor * stretch * stretch;
}

template <typename Real>
void MeshMeasures<Real>::energy(View x, std::span<Energy> out) const {
    parallel_for(blocks_.size(), block_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            double sum = 0.0;
            for (std::size_t n = blocks_[b].begin; n < blocks_[b].end; ++n) {
                sum += stored(x, springs_[n]);
            }
            const SpringKind kind = blocks_[b].kind;
            sum *= 0.5 * cloth_.materials[static_cast<std::size_t>(kind)].stiffness;
            out[b] = {};
            (kind == SpringKind::structural ? out[b].structural
             : kind == SpringKind::shear    ? out[b].shear
                                            : out[b].bend) = sum;
        }
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
void MeshMeasures<Real>::copy(View x, std::span<Vec3d> out) const {
    parallel_for(particles_.size(), particle_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            out[particles_[slot]] = vec3_cast<double>(x[slot]);
        }
    });
}

template class MeshMeasures<float>;
template class MeshMeasures<double>;

}  // namespace weft
