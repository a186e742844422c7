// What holds up particles that already lie on an obstacle, in the equations of an implicit method.
#pragma once

#include <cstddef>
#include <vector>

#include "weft/vec3.h"

namespace weft {

/// A particle that a step begins with on a surface and not leaving it.
struct ContactSupport {
    std::size_t slot = 0;
    std::size_t obstacle = 0;
    Vec3d normal{};       ///< outward
    double height = 0.0;  ///< normal.x on the surface [m]
};

/// An implicit step is long: did it know nothing of an obstacle, cloth that hangs from a patch of
/// contact would be taken through it, as what stops the patch between steps is the momentum of the
/// patch alone. So for the step each such particle is tied to the tangent plane by a spring, stiff
/// beside its inertia m / h^2, but so that how far it yields, which is how hard the particle
/// presses, is no rounding error in float. It pulls as well as it pushes: who is about to leave is
/// held back for one step, and is then no longer on the surface.
struct ContactSupports {
    static constexpr double stiffness = 10.0;  ///< in m / h^2

    std::vector<ContactSupport> list;  ///< by rising slot
    double rate = 0.0;                 ///< stiffness over mass [1/s2]

    [[nodiscard]] Vec3d acceleration(const ContactSupport& support, Vec3d x) const {
        return rate * (support.height - dot(support.normal, x)) * support.normal;
    }
};

}  // namespace weft
