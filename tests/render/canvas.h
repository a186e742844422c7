// A small framebuffer to draw into by hand, and to read.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl_context.h"
#include "render/renderer.h"
#include "support/waving_cloth.h"

namespace weft::test {

using Pixel = glm::vec3;  ///< red, green, blue in [0, 255]

/// One sample a pixel, painted in one colour that no scene has. Its context is current while it
/// lives.
class Canvas {
public:
    Canvas(int width, int height) : current_(context_), width_(width), height_(height) {
        const auto attach = [&](GLenum attachment, GLuint buffer, GLenum format) {
            glBindRenderbuffer(GL_RENDERBUFFER, buffer);
            glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
        };
        glBindFramebuffer(GL_FRAMEBUFFER, buffers_.framebuffer.name());
        attach(GL_COLOR_ATTACHMENT0, buffers_.colour.name(), GL_RGBA8);
        attach(GL_DEPTH_ATTACHMENT, buffers_.depth.name(), GL_DEPTH_COMPONENT24);
        wipe();
    }

    static constexpr Pixel paint{255.0F, 0.0F, 255.0F};
    void wipe() const {
        glBindFramebuffer(GL_FRAMEBUFFER, buffers_.framebuffer.name());
        glDisable(GL_SCISSOR_TEST);
        glClearColor(1.0F, 0.0F, 1.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
    [[nodiscard]] DrawTarget whole() const {
        return {buffers_.framebuffer.name(), width_, height_, 0, 0};
    }
    [[nodiscard]] DrawTarget part(int left, int bottom, int width, int height) const {
        return {buffers_.framebuffer.name(), width, height, left, bottom};
    }
    /// Pixels [row from the bottom][column].
    [[nodiscard]] std::vector<Pixel> pixels() const {
        std::vector<std::uint8_t> bytes(4 * static_cast<std::size_t>(width_ * height_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, buffers_.framebuffer.name());
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        std::vector<Pixel> result;
        for (std::size_t i = 0; i < bytes.size(); i += 4)
            result.emplace_back(bytes[i], bytes[i + 1], bytes[i + 2]);
        return result;
    }
    /// Where a point appears in the whole canvas: index into pixels().
    [[nodiscard]] std::size_t place_of(glm::vec3 point, const Camera& camera) const {
        const auto width = static_cast<float>(width_), height = static_cast<float>(height_);
        const glm::vec4 clip = camera.world_to_clip(width / height) * glm::vec4(point, 1.0F);
        const auto column = static_cast<std::size_t>((0.5F + 0.5F * clip.x / clip.w) * width);
        const auto row = static_cast<std::size_t>((0.5F + 0.5F * clip.y / clip.w) * height);
        return row * static_cast<std::size_t>(width_) + column;
    }

private:
    struct Buffers {
        GlRenderbuffer colour, depth;
        GlFramebuffer framebuffer;
    };

    GlContext context_;
    CurrentContext current_;
    Buffers buffers_;
    int width_, height_;
};

inline float brightness(Pixel pixel) {
    return (pixel.r + pixel.g + pixel.b) / 3.0F;
}

/// Mean difference of two pictures' channels, in [0, 255].
inline float difference(const std::vector<Pixel>& a, const std::vector<Pixel>& b) {
    float sum = 0.0F;
    for (std::size_t i = 0; i < a.size(); ++i) sum += brightness(glm::abs(a[i] - b[i]));
    return sum / static_cast<float>(a.size());
}

/// A waving cloth with all that draws it into a canvas of 480 x 270.
class DrawnCloth {
public:
    explicit DrawnCloth(WavingCloth waving, RenderDescription render = plain(),
                        const std::vector<ObstacleDescription>& obstacles = {})
        : cloth(std::move(waving)),
          stage(plan_stage(cloth.surface, cloth.rest, render, obstacles)),
          camera(choose_camera(stage, render)),
          renderer(cloth.surface, render) {
        renderer.set_stage(stage);
    }

    static RenderDescription plain() {
        RenderDescription render;
        render.size = {480, 270};
        render.texture = "plain";
        return render;
    }
    static RenderDescription seen_from(Vec3d eye, Vec3d target) {
        RenderDescription render = plain();
        render.camera = eye;
        render.target = target;
        render.mast = false;
        return render;
    }

    std::vector<Pixel> draw(const Canvas& canvas, const Frame& frame,
                            const DrawOptions& options = {}) {
        renderer.draw(frame, camera, canvas.whole(), options);
        return canvas.pixels();
    }
    [[nodiscard]] Frame at_rest() const { return {0, 0.0, cloth.rest, {}, {}}; }

    WavingCloth cloth;
    Stage stage;
    Camera camera;
    Renderer renderer;
};

}  // namespace weft::test
