// Drawing into a multisampled framebuffer, and reading the picture back.
#include "render/off_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "weft/error.h"

namespace weft {

namespace {

void attach(GLenum attachment, const GlRenderbuffer& buffer, GLenum format, GLint samples,
            const RenderDescription& render) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, render.size[0],
                                     render.size[1]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
}

void check_complete(const RenderDescription& render) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
    throw scene_error("render.size", fmt::format("[{}, {}]", render.size[0], render.size[1]),
                      "the OpenGL driver has no room for a picture of that size");
}

void check_size(const RenderDescription& render) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
    const auto [low, high] = std::minmax(render.size[0], render.size[1]);
    if (low >= 1 && high <= limit) return;
    throw scene_error("render.size", fmt::format("[{}, {}]", render.size[0], render.size[1]),
                      fmt::format("sides of 1 to {} pixels with this OpenGL driver", limit));
}

}  // namespace

/// Four samples a pixel are drawn, and resolved to one that is read.
struct OffScreenRenderer::Buffers {
    GlRenderbuffer samples_colour, samples_depth, colour;
    GlFramebuffer samples, resolved;

    explicit Buffers(const RenderDescription& render) {
        check_size(render);
        GLint most = 0;
        glGetIntegerv(GL_MAX_SAMPLES, &most);
        const GLint count = std::min(4, most);
        glBindFramebuffer(GL_FRAMEBUFFER, samples.name());
        attach(GL_COLOR_ATTACHMENT0, samples_colour, GL_RGBA8, count, render);
        attach(GL_DEPTH_ATTACHMENT, samples_depth, GL_DEPTH_COMPONENT24, count, render);
        check_complete(render);
        glBindFramebuffer(GL_FRAMEBUFFER, resolved.name());
        attach(GL_COLOR_ATTACHMENT0, colour, GL_RGBA8, 0, render);
        check_complete(render);
    }

    void read(Image& image) const {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, samples.name());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved.name());
        glBlitFramebuffer(0, 0, image.width, image.height, 0, 0, image.width, image.height,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved.name());
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
        // OpenGL's rows go upward, those of an Image downward.
        const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(image.width);
        auto top = image.rgba.begin();
        for (auto bottom = image.rgba.end() - row; top < bottom; top += row, bottom -= row)
            std::swap_ranges(top, top + row, bottom);
    }
};

OffScreenRenderer::OffScreenRenderer(const Surface& surface, const RenderDescription& render,
                                     std::vector<ObstacleDescription> obstacles)
    : surface_(&surface), render_(render), obstacles_(std::move(obstacles)) {
    const CurrentContext current(context_);
    // Held here until both stand: on an error they go before the context ceases to be current.
    auto buffers = std::make_unique<Buffers>(render);
    auto renderer = std::make_unique<Renderer>(surface, render);
    image_ = {render.size[0], render.size[1], {}};
    image_.rgba.resize(4 * static_cast<std::size_t>(image_.width) *
                       static_cast<std::size_t>(image_.height));
    buffers_ = std::move(buffers);
    renderer_ = std::move(renderer);
}

OffScreenRenderer::~OffScreenRenderer() {
    try {
        const CurrentContext current(context_);
        renderer_.reset();
        buffers_.reset();
    } catch (const Error&) {
        // Without its context nothing can be deleted; the driver does it with the context.
        (void)renderer_.release();
        (void)buffers_.release();
    }
}

void OffScreenRenderer::set_first_frame(const Frame& first) {
    const CurrentContext current(context_);
    const Stage stage = plan_stage(*surface_, first.positions, render_, obstacles_);
    camera_ = choose_camera(stage, render_);
    renderer_->set_stage(stage);
}

const Image& OffScreenRenderer::draw(const Frame& frame) {
    if (!camera_) set_first_frame(frame);
    const CurrentContext current(context_);
    renderer_->draw(frame, *camera_, {buffers_->samples.name(), image_.width, image_.height});
    buffers_->read(image_);
    return image_;
}

}  // namespace weft
