// Which particles a cloth joins by springs.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace weft {

enum class SpringKind : std::uint8_t { structural, shear, bend };
inline constexpr std::array<std::string_view, 3> spring_kind_names{"structural", "shear", "bend"};

/// One spring of the rest state. With stiffness per spring k is the material's stiffness; with
/// stiffness per width K it is k = K * width_factor, where width_factor is the width of the strip
/// that the spring stands for over its rest length (van Gelder 1998, k = E h A / L^2).
struct Spring {
    std::uint32_t p = 0, q = 0;  ///< particles, p < q
    SpringKind kind = SpringKind::structural;
    double rest_length = 0.0;   ///< [m]
    double width_factor = 1.0;  ///< [1]
};

}  // namespace weft
