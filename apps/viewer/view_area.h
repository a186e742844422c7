// Rectangles of the window in which cloths are shown, and from their pixels to a camera's cursor.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "render/camera.h"

namespace weft::viewer {

/// Rectangle of the window's framebuffer, from its upper left corner [pixels].
struct ViewArea {
    int left = 0, top = 0, width = 0, height = 0;

    [[nodiscard]] bool empty() const { return width < 1 || height < 1; }
    /// Width over height. @pre not empty().
    [[nodiscard]] float aspect() const {
        return static_cast<float>(width) / static_cast<float>(height);
    }
    [[nodiscard]] bool contains(glm::vec2 pixel) const;
};

/// Where each of `count` cloths stands in the area, with thin gaps: one; two beside each other, or
/// one above the other where that shows them larger; else two rows, the last one shared evenly.
std::vector<ViewArea> split_area(const ViewArea& area, std::size_t count);

/// The area that holds a pixel.
std::optional<std::size_t> area_at(std::span<const ViewArea> areas, glm::vec2 pixel);

/// Of a pixel of the window, y downward: from -1 to 1 across the area, x rightward, y upward.
glm::vec2 cursor_in(const ViewArea& area, glm::vec2 pixel);

/// Where the area shows a point of the world [pixels of the window]; none behind the camera.
std::optional<glm::vec2> pixel_of(const ViewArea& area, const Camera& camera, glm::vec3 point);

}  // namespace weft::viewer
