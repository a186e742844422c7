#include "simulation/grip_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "simulation/scene_require.h"

namespace weft {

namespace {

bool is_pinned(const ClothModel& cloth, std::size_t particle) {
    const auto found =
        std::lower_bound(cloth.pins.begin(), cloth.pins.end(), particle,
                         [](const Pin& pin, std::size_t sought) { return pin.particle < sought; });
    return found != cloth.pins.end() && found->particle == particle;
}

}  // namespace

void check_grips(std::span<const Grip> grips, std::size_t particle_count) {
    for (std::size_t n = 0; n < grips.size(); ++n) {
        const Grip& grip = grips[n];
        const std::string key = fmt::format("grips[{}]", n);
        require(grip.particle < particle_count, key + ".particle", fmt::format("{}", grip.particle),
                fmt::format("the cloth has particles 0 to {}", particle_count - 1));
        require_finite(key + ".point", grip.point);
        require_not_negative(key + ".stiffness", grip.stiffness);
        require_not_negative(key + ".damping", grip.damping);
    }
}

GripSprings grip_springs(std::span<const Grip> grips, const ClothModel& cloth) {
    GripSprings springs;
    for (const Grip& grip : grips) {
        if (is_pinned(cloth, grip.particle)) continue;
        springs.push_back({cloth.slot(grip.particle), cloth.masses[grip.particle], grip.stiffness,
                           grip.damping, grip.stiffness * grip.point});
    }
    std::stable_sort(springs.begin(), springs.end(),
                     [](const GripSpring& a, const GripSpring& b) { return a.slot < b.slot; });
    GripSprings together;
    for (const GripSpring& spring : springs) {
        if (together.empty() || together.back().slot != spring.slot) {
            together.push_back(spring);
            continue;
        }
        together.back().stiffness += spring.stiffness;
        together.back().damping += spring.damping;
        together.back().pull += spring.pull;
    }
    return together;
}

}  // namespace weft
