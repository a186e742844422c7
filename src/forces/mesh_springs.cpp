#include "forces/mesh_springs.h"

#include <cmath>

namespace weft {

template <typename Real>
MeshSprings<Real>::MeshSprings(const ClothModel& cloth) : first_(cloth.layout.slot_count() + 1, 0) {
    cloth.for_each_spring_with_slots(
        [&](const Spring&, const SpringConstants&, std::size_t p, std::size_t q) {
            ++first_[p + 1];
            ++first_[q + 1];
        });
    for (std::size_t s = 0; s < cloth.layout.slot_count(); ++s) first_[s + 1] += first_[s];
    neighbours_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    cloth.for_each_spring_with_slots([&](const Spring& spring, const SpringConstants& constants,
                                         std::size_t p, std::size_t q) {
        const Neighbour other{static_cast<std::uint32_t>(q), static_cast<Real>(spring.rest_length),
                              static_cast<Real>(constants.stiffness),
                              static_cast<Real>(constants.damping)};
        neighbours_[next[p]++] = other;
        neighbours_[next[q]++] = {static_cast<std::uint32_t>(p), other.rest_length, other.stiffness,
                                  other.damping};
    });
}

template <typename Real>
void MeshSprings<Real>::add_forces(ConstVec3View<Real> x, ConstVec3View<Real> v, Vec3View<Real> f,
                                   std::size_t begin, std::size_t end) const {
    for (std::size_t s = begin; s < end; ++s) {
        const Vec3<Real> xs = x[s], vs = v[s];
        Vec3<Real> sum{};
        for (std::size_t n = first_[s]; n < first_[s + 1]; ++n) {
            const Neighbour& other = neighbours_[n];
            const Vec3<Real> d = x[other.slot] - xs;
            const Real length = weft::length(d);
            const Real inverse = length > 0 ? 1 / length : Real{0};
            const Real rate = dot(v[other.slot] - vs, d) * inverse;
            const Real tension =
                other.stiffness * (length - other.rest_length) + other.damping * rate;
            sum += (tension * inverse) * d;
        }
        f.add(s, sum);
    }
}

template class MeshSprings<float>;
template class MeshSprings<double>;

}  // namespace weft
