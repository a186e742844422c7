#include "forces/mesh_air.h"

namespace weft {

template <typename Real>
MeshAir<Real>::MeshAir(const WindDescription& wind, const Surface& surface,
                       const ParticleLayout& layout)
    : constants_(wind), first_(layout.slot_count() + 1, 0), thirds_(surface.triangles.size()) {
    corners_.reserve(surface.triangles.size());
    for (const auto& triangle : surface.triangles) {
        const auto slot = [&](std::uint32_t corner) {
            return static_cast<std::uint32_t>(layout.slot(surface.particle(corner)));
        };
        corners_.push_back({slot(triangle[0]), slot(triangle[1]), slot(triangle[2])});
        for (const std::uint32_t s : corners_.back()) ++first_[s + 1];
    }
    for (std::size_t s = 0; s < layout.slot_count(); ++s) first_[s + 1] += first_[s];
    triangles_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < corners_.size(); ++t) {
        for (const std::uint32_t s : corners_[t]) {
            triangles_[next[s]++] = static_cast<std::uint32_t>(t);
        }
    }
}

template <typename Real>
void MeshAir<Real>::compute(Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v,
                            std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
        const auto [a, b, c] = corners_[t];
        const Vec3<Real> centre_velocity = Real(1.0 / 3.0) * (v[a] + v[b] + v[c]);
        const Vec3<Real> normal = cross(x[b] - x[a], x[c] - x[a]);
        thirds_.set(t, plate_force_third(constants_, wind - centre_velocity, normal));
    }
}

template <typename Real>
void MeshAir<Real>::add_forces(Vec3View<Real> f, std::size_t begin, std::size_t end) const {
    for (std::size_t s = begin; s < end; ++s) {
        Vec3<Real> sum{};
        for (std::size_t n = first_[s]; n < first_[s + 1]; ++n) sum += thirds_[triangles_[n]];
        f.add(s, sum);
    }
}

template <typename Real>
double MeshAir<Real>::power(ConstVec3View<Real> v) const {
    double power = 0.0;
    for (std::size_t t = 0; t < corners_.size(); ++t) {
        const auto [a, b, c] = corners_[t];
        power += dot(vec3_cast<double>(thirds_[t]), vec3_cast<double>(v[a] + v[b] + v[c]));
    }
    return power;
}

template class MeshAir<float>;
template class MeshAir<double>;

}  // namespace weft
