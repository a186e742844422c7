#include "forces/linearised.h"

#include <algorithm>

namespace weft {

template <typename Real>
void stiffness_product(const ClothModel& cloth, ConstVec3View<Real> x, ConstVec3View<Real> u,
                       Vec3View<Real> out) {
    for (std::size_t s = 0; s < out.size; ++s) out.set(s, {});
    cloth.for_each_spring_with_slots(
        [&](const Spring& spring, const SpringConstants& constants, std::size_t p, std::size_t q) {
            const Vec3<Real> d = x[q] - x[p];
            const Real l = length(d);
            if (!(l > 0)) return;
            const Vec3<Real> n = d / l;
            const Vec3<Real> du = u[q] - u[p];
            const Real along = dot(n, du);
            const Real k = static_cast<Real>(constants.stiffness);
            const Real across = std::max(Real{0}, 1 - static_cast<Real>(spring.rest_length) / l);
            const Vec3<Real> force = k * ((along * (1 - across)) * n + across * du);
            out.add(p, -force);
            out.add(q, force);
        });
}

template <typename Real>
void damping_product(const ClothModel& cloth, const ForcesDescription& forces,
                     ConstVec3View<Real> x, ConstVec3View<Real> u, Vec3View<Real> out) {
    const Real drag = static_cast<Real>(forces.damping);
    for (std::size_t s = 0; s < out.size; ++s) out.set(s, drag * u[s]);
    cloth.for_each_spring_with_slots(
        [&](const Spring&, const SpringConstants& constants, std::size_t p, std::size_t q) {
            if (constants.damping == 0.0) return;
            const Vec3<Real> d = x[q] - x[p];
            const Real squared = dot(d, d);
            if (!(squared > 0)) return;
            const Real c = static_cast<Real>(constants.damping);
            const Vec3<Real> force = (c * dot(d, u[q] - u[p]) / squared) * d;
            out.add(p, -force);
            out.add(q, force);
        });
}

template void stiffness_product(const ClothModel&, ConstVec3View<float>, ConstVec3View<float>,
                                Vec3View<float>);
template void stiffness_product(const ClothModel&, ConstVec3View<double>, ConstVec3View<double>,
                                Vec3View<double>);
template void damping_product(const ClothModel&, const ForcesDescription&, ConstVec3View<float>,
                              ConstVec3View<float>, Vec3View<float>);
template void damping_product(const ClothModel&, const ForcesDescription&, ConstVec3View<double>,
                              ConstVec3View<double>, Vec3View<double>);

}  // namespace weft
