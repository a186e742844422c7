// Where ImGui draws over the cloths: pixels of the framebuffer to its units.
#pragma once

#include <imgui.h>

#include <glm/glm.hpp>

namespace weft::viewer {

struct Canvas {
    ImDrawList* list = nullptr;
    float pixels_per_unit = 1.0F;  ///< of ImGui's co-ordinates
    float scale = 1.0F;            ///< pixels of a mark that is one large

    [[nodiscard]] ImVec2 at(glm::vec2 pixel) const {
        return {pixel.x / pixels_per_unit, pixel.y / pixels_per_unit};
    }
    /// A length that looks the same on every screen, in ImGui's units.
    [[nodiscard]] float length(float marks) const { return marks * scale / pixels_per_unit; }
};

}  // namespace weft::viewer
