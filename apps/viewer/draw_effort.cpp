// What is given up first: light and shadow per pixel, then smooth edges, then the fineness of a
// fine cloth, then the shadow. On a driver that draws on the processor each about halves the cost.
#include "viewer/draw_effort.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace weft::viewer {

std::vector<DrawEffort> draw_efforts(std::span<const int> samples, bool fine) {
    std::vector<DrawEffort> efforts{{samples.front(), {}}};
    DrawEffort cheaper = efforts.back();
    const auto add = [&] { efforts.push_back(cheaper); };
    cheaper.options.effort = Effort::quick;
    for (const int count : samples) {
        cheaper.samples = count;
        add();
    }
    if (fine) {
        cheaper.options.cloth_step = 2;
        add();
    }
    cheaper.options.shadow = false;
    add();
    return efforts;
}

bool is_fine(const Surface& surface) {
    constexpr std::size_t many = 22500;  // 150 x 150
    return surface.particle_count > many;
}

std::size_t first_level(std::span<const DrawEffort> efforts, std::string_view driver) {
    constexpr std::array<std::string_view, 3> on_the_processor{"llvmpipe", "softpipe", "SWR"};
    const bool slow = std::any_of(
        on_the_processor.begin(), on_the_processor.end(),
        [driver](std::string_view name) { return driver.find(name) != std::string_view::npos; });
    if (!slow) return 0;
    const auto plain = std::find_if(efforts.begin(), efforts.end(), [](const DrawEffort& effort) {
        return effort.samples == 1 && effort.options.effort == Effort::quick;
    });
    return plain == efforts.end() ? efforts.size() - 1
                                  : static_cast<std::size_t>(plain - efforts.begin());
}

std::string describe(const DrawEffort& effort) {
    std::string text = effort.samples == 1 ? "1 sample a pixel"
                                           : fmt::format("{} samples a pixel", effort.samples);
    if (effort.options.effort == Effort::quick) text += ", quick light";
    text += effort.options.shadow ? ", shadow" : ", no shadow";
    if (effort.options.cloth_step > 1) text += ", coarser cloth";
    return text;
}

}  // namespace weft::viewer
