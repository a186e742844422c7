// Choosing the range of a colour scale.
#include "viewer/strain_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace weft::viewer {

namespace {

constexpr std::array steps{0.005F, 0.01F, 0.02F, 0.05F, 0.1F, 0.2F, 0.5F, 1.0F};

std::size_t step_of(float strain) {
    const auto found = std::lower_bound(steps.begin(), steps.end(), strain);
    return found == steps.end() ? steps.size() - 1
                                : static_cast<std::size_t>(found - steps.begin());
}

}  // namespace

float usual_strain(std::span<const DrawnSpring> springs, const Frame& frame) {
    constexpr std::size_t enough = 4000;
    const std::size_t stride = std::max<std::size_t>(springs.size() / enough, 1);
    std::vector<float> strains;
    for (std::size_t n = 0; n < springs.size(); n += stride) {
        const DrawnSpring& spring = springs[n];
        if (spring.rest_length <= 0.0F) continue;
        const glm::vec3 p = to_glm(frame.positions[spring.p]),
                        q = to_glm(frame.positions[spring.q]);
        const float strain = std::abs(glm::distance(p, q) / spring.rest_length - 1.0F);
        if (std::isfinite(strain)) strains.push_back(strain);
    }
    if (strains.empty()) return 0.0F;
    const auto rank = static_cast<std::ptrdiff_t>(strains.size() - 1 - strains.size() / 50);
    std::nth_element(strains.begin(), strains.begin() + rank, strains.end());
    return strains[static_cast<std::size_t>(rank)];
}

float round_strain(float strain) {
    return steps[step_of(strain)];
}

void StrainScale::follow(float strain) {
    const std::size_t wanted = step_of(strain), present = step_of(range_);
    if (wanted > present || wanted + 2 <= present) range_ = steps[wanted];
}

std::string percent_text(float strain) {
    return fmt::format("{:.3g} %", 100.0F * strain);
}

}  // namespace weft::viewer
