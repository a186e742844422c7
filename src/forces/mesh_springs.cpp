#include "forces/mesh_springs.h"

#include <cmath>

namespace weft {

template <typename Real>
MeshSprings<Real>::MeshSprings(const ClothModel& cloth) : first_(cloth.particle_count + 1, 0) {
    cloth.for_each_spring([&](const Spring& spring, const SpringConstants&) {
        ++first_[spring.p + 1];
        ++first_[spring.q + 1];
    });
    for (std::size_t p = 0; p < cloth.particle_count; ++p) first_[p + 1] += first_[p];
    neighbours_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    cloth.for_each_spring([&](const Spring& spring, const SpringConstants& constants) {
        const Neighbour other{spring.q, static_cast<Real>(spring.rest_length),
                              static_cast<Real>(constants.stiffness),
                              static_cast<Real>(constants.damping)};
        neighbours_[next[spring.p]++] = other;
        neighbours_[next[spring.q]++] = {spring.p, other.rest_length, other.stiffness,
                                         other.damping};
    });
}

template <typename Real>
void MeshSprings<Real>::add_forces(ConstVec3View<Real> x, ConstVec3View<Real> v, Vec3View<Real> f,
                                   std::size_t begin, std::size_t end) const {
    for (std::size_t p = begin; p < end; ++p) {
        const Vec3<Real> xp = x[p], vp = v[p];
        Vec3<Real> sum{};
        for (std::size_t n = first_[p]; n < first_[p + 1]; ++n) {
            const Neighbour& other = neighbours_[n];
            const Vec3<Real> d = x[other.particle] - xp;
            const Real length = weft::length(d);
            const Real inverse = length > 0 ? 1 / length : Real{0};
            const Real rate = dot(v[other.particle] - vp, d) * inverse;
            const Real tension =
                other.stiffness * (length - other.rest_length) + other.damping * rate;
            sum += (tension * inverse) * d;
        }
        f.add(p, sum);
    }
}

template class MeshSprings<float>;
template class MeshSprings<double>;

}  // namespace weft
