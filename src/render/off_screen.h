// Pictures without a window.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/camera.h"
#include "render/gl_context.h"
#include "render/image.h"
#include "render/renderer.h"
#include "weft/frame.h"
#include "weft/scene.h"

namespace weft {

/// A renderer with an OpenGL context and framebuffers of its own. May be used from any thread, one
/// at a time; the context is current only inside its functions.
class OffScreenRenderer {
public:
    /// @param surface outlives the renderer.  @param obstacles stand in the picture.
    /// @throws Error (file) where OpenGL is not available or the texture cannot be read;
    ///         Error (usage) where the driver takes no picture of that size.
    OffScreenRenderer(const Surface& surface, const RenderDescription& render,
                      std::vector<ObstacleDescription> obstacles = {});
    ~OffScreenRenderer();
    OffScreenRenderer(const OffScreenRenderer&) = delete;
    OffScreenRenderer& operator=(const OffScreenRenderer&) = delete;

    /// Plans stage and camera from frame 0; without it the first frame drawn serves.
    void set_first_frame(const Frame& first);
    /// @return the picture of the frame, render.size pixels; valid until the next call.
    const Image& draw(const Frame& frame);

private:
    struct Buffers;

    const Surface* surface_;
    RenderDescription render_;
    std::vector<ObstacleDescription> obstacles_;
    GlContext context_;
    std::unique_ptr<Buffers> buffers_;    ///< destroyed while the context is current
    std::unique_ptr<Renderer> renderer_;  ///< the same
    std::optional<Camera> camera_;        ///< none before the stage is planned
    Image image_;
};

}  // namespace weft
