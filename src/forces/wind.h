// The wind over time.
#pragma once

#include <cstdint>

#include "weft/scene.h"

namespace weft {

/// Wind velocity at a time [m/s], the same everywhere. With the gust model "coefficient" each
/// component of the mean is multiplied by its own factor ("Flag in the Wind", section 2.1): at
/// every multiple of the period a factor is drawn uniformly from [1 - spread, 1 + spread]; between
/// draws it follows the cubic 3 s^2 - 2 s^3.
Vec3d wind_velocity(const WindDescription& wind, double time);

}  // namespace weft
