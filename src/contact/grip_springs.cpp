#include "contact/grip_springs.h"

namespace weft {

template <typename Real>
void pull_grips(GripSprings& grips, double h, Vec3View<Real> x, Vec3View<Real> v) {
    for (GripSpring& grip : grips) {
        const Vec3d place = vec3_cast<double>(x[grip.slot]);
        const Vec3d velocity = vec3_cast<double>(v[grip.slot]);
        const double inertia = grip.mass + h * grip.damping + h * h * grip.stiffness;
        const Vec3d change = (h / inertia) * grip.force(place, (place - grip.start) / h);
        grip.velocity = (place - grip.start) / h + change;
        v.set(grip.slot, vec3_cast<Real>(velocity + change));
        x.set(grip.slot, vec3_cast<Real>(place + h * change));
    }
}

template void pull_grips(GripSprings&, double, Vec3View<float>, Vec3View<float>);
template void pull_grips(GripSprings&, double, Vec3View<double>, Vec3View<double>);

}  // namespace weft
