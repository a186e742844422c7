// The little that painting a texture needs: colours, coverage of a shape's edge, a loop over
// pixels.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

#include "render/image.h"

namespace weft {

/// A colour as it stands in an Image: sRGB, each channel in [0, 255].
using Paint = glm::vec3;

/// How much of a pixel lies inside a shape: 1 inside, 0 outside, a ramp one pixel wide between.
/// @param distance signed distance to the shape's edge, negative inside; @param pixel in its unit.
inline float coverage(float distance, float pixel) {
    return std::clamp(0.5F - distance / pixel, 0.0F, 1.0F);
}

/// Fills an opaque picture; `colour(x, y)` is asked at pixel centres, x rightward and y downward
/// in pixels.
template <typename Colour>
Image paint_image(int width, int height, Colour colour) {
    Image image{width, height, {}};
    image.rgba.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const Paint paint =
                colour(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F);
            for (int channel = 0; channel < 3; ++channel) {
                const float value = std::clamp(paint[channel], 0.0F, 255.0F);
                image.rgba.push_back(static_cast<std::uint8_t>(std::lround(value)));
            }
            image.rgba.push_back(255);
        }
    }
    return image;
}

}  // namespace weft
