// Lines and points over a drawn scene: springs, normals, pins, arrows. The lists are made by
// overlay_shapes.h.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "render/camera.h"
#include "render/gl_object.h"
#include "render/renderer.h"

namespace weft {

struct OverlayVertex {
    glm::vec3 position;                  ///< [m]
    std::array<std::uint8_t, 4> colour;  ///< sRGB and opacity
};

/// Draws lists of lines and points, hidden by what is nearer in the target's depth. Made, used and
/// destroyed while one OpenGL context (3.3 core or later) is current.
class Overlay {
public:
    Overlay();

    /// @param lines two vertices a line.  @param width [pixels]; at most 1 is one pixel, drawn in
    /// half of the time and with smooth edges only where the target has several samples.
    void draw_lines(std::span<const OverlayVertex> lines, float width, const Camera& camera,
                    const DrawTarget& target);
    /// Round points. @param size their diameter [pixels].
    void draw_points(std::span<const OverlayVertex> points, float size, const Camera& camera,
                     const DrawTarget& target);

private:
    void draw_thin_lines(std::span<const OverlayVertex> lines, const Camera& camera,
                         const DrawTarget& target);

    GlProgram line_program_, thin_line_program_, point_program_;
    GlVertexArray mark_array_, no_array_;
    GlBuffer vertices_;
    GlTexture ends_;         ///< vertices_ as the shader of lines reads them
    GLint most_texels_ = 0;  ///< that it may hold
};

}  // namespace weft
