#include "forces/energy.h"

#include <cmath>

namespace weft {

namespace {

template <typename Real>
Vec3d along(ConstVec3View<Real> a, std::size_t slot_p, std::size_t slot_q) {
    return vec3_cast<double>(a[slot_q]) - vec3_cast<double>(a[slot_p]);
}

}  // namespace

template <typename Real>
Energy energy(const ClothModel& cloth, const ForcesDescription& forces, ConstVec3View<Real> x,
              ConstVec3View<Real> v) {
    Energy sum;
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        const Vec3d velocity = vec3_cast<double>(v[slot]);
        sum.kinetic += 0.5 * cloth.masses[p] * dot(velocity, velocity);
        sum.gravity -= cloth.masses[p] * dot(forces.gravity, vec3_cast<double>(x[slot]));
    });
    cloth.for_each_spring_with_slots(
        [&](const Spring& spring, const SpringConstants& constants, std::size_t p, std::size_t q) {
            const double stretch = length(along(x, p, q)) - spring.rest_length;
            const double stored = 0.5 * constants.stiffness * stretch * stretch;
            switch (spring.kind) {
                case SpringKind::structural:
                    sum.structural += stored;
                    break;
                case SpringKind::shear:
                    sum.shear += stored;
                    break;
                case SpringKind::bend:
                    sum.bend += stored;
                    break;
            }
        });
    return sum;
}

template <typename Real>
double dashpot_power(const ClothModel& cloth, ConstVec3View<Real> x, ConstVec3View<Real> v) {
    double power = 0.0;
    cloth.for_each_spring_with_slots(
        [&](const Spring&, const SpringConstants& constants, std::size_t p, std::size_t q) {
            const Vec3d d = along(x, p, q);
            const double squared = dot(d, d);
            if (constants.damping == 0.0 || !(squared > 0.0)) return;
            const double rate = dot(along(v, p, q), d);
            power -= constants.damping * rate * rate / squared;
        });
    return power;
}

template <typename Real>
double drag_power(const ClothModel& cloth, const ForcesDescription& forces, ConstVec3View<Real> v) {
    double sum = 0.0;
    cloth.layout.for_each([&](std::size_t, std::size_t slot) {
        const Vec3d velocity = vec3_cast<double>(v[slot]);
        sum += dot(velocity, velocity);
    });
    return -forces.damping * sum;
}

template <typename Real>
SpringStrain largest_strain(const ClothModel& cloth, ConstVec3View<Real> x) {
    SpringStrain largest;
    cloth.for_each_spring_with_slots(
        [&](const Spring& spring, const SpringConstants&, std::size_t p, std::size_t q) {
            const double strain = length(along(x, p, q)) / spring.rest_length - 1.0;
            if (!(std::abs(strain) <= std::abs(largest.strain))) {  // takes NaN too
                if (std::isnan(largest.strain)) return;
                largest = {strain, spring.p, spring.q,
                           spring_kind_names[static_cast<std::size_t>(spring.kind)]};
            }
        });
    return largest;
}

template Energy energy(const ClothModel&, const ForcesDescription&, ConstVec3View<float>,
                       ConstVec3View<float>);
template Energy energy(const ClothModel&, const ForcesDescription&, ConstVec3View<double>,
                       ConstVec3View<double>);
template double dashpot_power(const ClothModel&, ConstVec3View<float>, ConstVec3View<float>);
template double dashpot_power(const ClothModel&, ConstVec3View<double>, ConstVec3View<double>);
template double drag_power(const ClothModel&, const ForcesDescription&, ConstVec3View<float>);
template double drag_power(const ClothModel&, const ForcesDescription&, ConstVec3View<double>);
template SpringStrain largest_strain(const ClothModel&, ConstVec3View<float>);
template SpringStrain largest_strain(const ClothModel&, ConstVec3View<double>);

}  // namespace weft
