// Values refused with their key and what is allowed.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "simulation/scene_rules.h"
#include "weft/error.h"
#include "weft/vec3.h"

namespace weft {

inline std::string value_text(double value) {
    return fmt::format("{}", value);
}
inline std::string value_text(Vec3d v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}
template <typename Number>
std::string value_text(const std::array<Number, 2>& pair) {
    return fmt::format("[{}, {}]", pair[0], pair[1]);
}

/// @throws Error (usage) unless it holds; likewise below.
inline void require(bool holds, const std::string& key, const std::string& value,
                    std::string_view allowed) {
    if (!holds) throw scene_error(key, value, std::string(allowed));
}

inline void require_not_negative(const std::string& key, double value) {
    require(std::isfinite(value) && value >= 0.0, key, value_text(value),
            scene_rules::not_negative);
}

inline void require_finite(const std::string& key, Vec3d value) {
    require(is_finite(value), key, value_text(value), scene_rules::vector);
}

}  // namespace weft
