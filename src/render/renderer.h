// Draws a cloth with its mast, ground, sky and shadow by OpenGL 3.3; the same for files and
// windows.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "render/camera.h"
#include "render/cloth_mesh.h"
#include "render/gl_object.h"
#include "render/scene_programs.h"
#include "render/shadow_map.h"
#include "render/solid_mesh.h"
#include "render/stage.h"
#include "weft/frame.h"
#include "weft/scene.h"

namespace weft {

/// Where to draw: a rectangle of a framebuffer with colour and depth. Colours come sRGB encoded, so
/// GL_FRAMEBUFFER_SRGB stays off.
struct DrawTarget {
    GLuint framebuffer = 0;     ///< 0: the window
    int width = 0, height = 0;  ///< [pixels]
    int left = 0, bottom = 0;   ///< corner of the rectangle [pixels]
};

/// What of a frame is drawn.
struct DrawOptions {
    bool cloth = true;   ///< else only what stands around it
    bool shadow = true;  ///< else nothing casts any
    Effort effort = Effort::full;
    /// Every which row and column of a grid is drawn: 2 leaves a quarter of the triangles. Other
    /// surfaces are drawn whole.
    std::uint32_t cloth_step = 1;

    friend bool operator==(const DrawOptions&, const DrawOptions&) = default;
};

/// Draws frames of one cloth. Everything from making to destroying it happens while the same OpenGL
/// context (3.3 core or later) is current.
class Renderer {
public:
    /// @param surface outlives the renderer.
    /// @throws Error (file) where the texture cannot be read or the driver refuses.
    Renderer(const Surface& surface, const RenderDescription& render);

    /// Sets mast, obstacles, ground and sun; before the first draw(), and where they change, as
    /// often as every frame.
    void set_stage(const Stage& stage);

    /// Draws one frame and replaces all that was in the target's rectangle, and nothing else.
    /// Leaves the target bound and depth test, culling and blending off.
    void draw(const Frame& frame, const Camera& camera, const DrawTarget& target,
              const DrawOptions& options = {});

private:
    struct Passes;  ///< what one picture is made with

    Passes passes_for(const DrawOptions& options);
    void build_solids(Effort effort);
    std::optional<Box> casters(const DrawOptions& options) const;
    void update_scene_block(const Camera& camera, const DrawTarget& target, const Passes& passes,
                            const std::optional<Box>& casters) const;
    void cast_shadows(const Passes& passes, const DrawOptions& options);
    void draw_scene(const DrawTarget& target, const Passes& passes, const DrawOptions& options);
    void draw_ground(const Passes& passes) const;
    void draw_surroundings(const Passes& passes) const;

    ClothMesh cloth_;
    /// [effort]; made when they are first asked for.
    std::array<std::optional<ScenePrograms>, 2> programs_;
    std::array<std::optional<ShadowMap>, 2> shadow_maps_;
    GlProgram shadow_program_;
    GlBuffer scene_buffer_;
    SolidMesh mast_, obstacles_;
    std::optional<Box> obstacle_bounds_;
    GlVertexArray no_array_;
    Stage stage_;
    std::optional<Effort> solids_built_;  ///< the effort that mast_ and obstacles_ were built for
    /// With which the last shadow map was drawn; none where the scene has changed since.
    std::optional<DrawOptions> shadow_cast_;
};

}  // namespace weft
