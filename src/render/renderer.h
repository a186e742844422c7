// Draws a cloth with its mast, ground, sky and shadow by OpenGL 3.3; the same for files and
// windows.
#pragma once

#include "render/camera.h"
#include "render/cloth_mesh.h"
#include "render/gl_object.h"
#include "render/shadow_map.h"
#include "render/stage.h"
#include "weft/frame.h"
#include "weft/scene.h"

namespace weft {

/// Where to draw: a framebuffer with colour and depth, the whole of it. Colours come sRGB encoded,
/// so GL_FRAMEBUFFER_SRGB stays off.
struct DrawTarget {
    GLuint framebuffer = 0;  ///< 0: the window
    int width = 0, height = 0;
};

/// Draws frames of one cloth. Everything from making to destroying it happens while the same OpenGL
/// context (3.3 core or later) is current.
class Renderer {
public:
    /// @param surface outlives the renderer.
    /// @throws Error (file) where the texture cannot be read or the driver refuses.
    Renderer(const Surface& surface, const RenderDescription& render);

    /// Sets mast, ground and sun; once before the first draw().
    void set_stage(const Stage& stage);

    /// Draws one frame and replaces all that was in the target. Leaves the target bound and depth
    /// test, culling and blending off.
    void draw(const Frame& frame, const Camera& camera, const DrawTarget& target);

private:
    void cast_shadows() const;
    void draw_scene(const DrawTarget& target) const;
    void update_scene_block(const Camera& camera, const DrawTarget& target, const Box& cloth) const;

    ClothMesh cloth_;
    GlProgram cloth_program_, solid_program_, ground_program_, sky_program_, shadow_program_;
    GlBuffer scene_buffer_, solid_vertices_, solid_indices_;
    GlVertexArray solid_array_, no_array_;
    GLsizei solid_index_count_ = 0;
    ShadowMap shadow_map_;
    Stage stage_;
};

}  // namespace weft
