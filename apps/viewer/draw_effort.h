// The levels of effort that drawing can take, from the best to the cheapest.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/renderer.h"

namespace weft::viewer {

struct DrawEffort {
    int samples = 4;  ///< a pixel
    DrawOptions options;
};

/// @param samples a pixel that the driver offers, falling; at least one.
/// @param fine whether the cloth has so many rows and columns that every second will do.
std::vector<DrawEffort> draw_efforts(std::span<const int> samples, bool fine);

/// Whether that is so.
bool is_fine(const Surface& surface);

/// The level to begin with: the best, or what a driver that draws on the processor can do at all.
/// @param driver GL_RENDERER.
std::size_t first_level(std::span<const DrawEffort> efforts, std::string_view driver);

/// "4 samples a pixel, shadow".
std::string describe(const DrawEffort& effort);

}  // namespace weft::viewer
