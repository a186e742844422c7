// The force of the air on a flat plate.
#pragma once

#include <cmath>

#include "weft/scene.h"
#include "weft/vec3.h"

namespace weft {

/// What of a WindDescription the force needs, in the precision of the run.
template <typename Real>
struct AirConstants {
    Real normal = 0;      ///< rho * drag / 4 [kg/m3]; applied to |N| = 2 A
    Real tangential = 0;  ///< rho * C_f / 2 [kg/m3]; the same

    AirConstants() = default;
    explicit AirConstants(const WindDescription& wind)
        : normal(static_cast<Real>(wind.air_density * wind.drag / 4.0)),
          tangential(static_cast<Real>(wind.air_density * wind.skin_friction / 2.0)) {}
};

/// A third of the air's force on a flat plate of normal N (|N| = twice its area A) in the relative
/// wind v_r: what each corner of a triangle takes [N].
///     F = 1/2 rho A |v_r|^2 v_n / (0.222 |v_n| + 0.283 |v_r|) n + 1/2 rho (2A) C_f |v_t| v_t
/// with v_n = v_r.n and v_t = v_r - v_n n: separated flow past a plate at any angle (Hoerner,
/// Fluid-Dynamic Drag), with friction on both sides; zero where |v_r| = 0 or A = 0.
template <typename Real>
inline Vec3<Real> plate_force_third(const AirConstants<Real>& air, Vec3<Real> relative_wind,
                                    Vec3<Real> normal) {
    const Real twice_area = length(normal);
    const Real speed = length(relative_wind);
    const Vec3<Real> n = (twice_area > 0 ? 1 / twice_area : Real{0}) * normal;
    const Real v_n = dot(relative_wind, n);
    const Vec3<Real> v_t = relative_wind - v_n * n;
    const Real resistance = Real(0.222) * std::abs(v_n) + Real(0.283) * speed;
    const Real across =
        air.normal * twice_area * speed * speed * v_n * (resistance > 0 ? 1 / resistance : Real{0});
    const Real along = air.tangential * twice_area * length(v_t);
    return Real(1.0 / 3.0) * (across * n + along * v_t);
}

}  // namespace weft
