// Where cloths are drawn before the window shows them: with several samples a pixel, as large as
// its area of the window.
#pragma once

#include <vector>

#include "render/gl_object.h"
#include "viewer/view_area.h"

namespace weft::viewer {

/// Made, used and destroyed while one OpenGL context is current.
class ViewFramebuffer {
public:
    /// Numbers of samples a pixel that the driver really makes of 4, 2 and 1, falling, each once.
    static std::vector<int> offered_samples();

    /// Whether the window's framebuffer has depth of its own: then pictures of one sample a pixel
    /// are drawn there at once, which saves copying them.
    static bool window_has_depth();

    /// Gives it a size and samples; cheap where they stay. Leaves it bound.
    void prepare(int width, int height, int samples);
    [[nodiscard]] GLuint name() const { return framebuffer_.name(); }

    /// Copies it into the window's framebuffer, which must not be multisampled and stays bound.
    /// @param window_height of that framebuffer [pixels].
    void show(const ViewArea& area, int window_height) const;

private:
    GlRenderbuffer colour_, depth_;
    GlFramebuffer framebuffer_;
    int width_ = 0, height_ = 0, samples_ = -1;
};

}  // namespace weft::viewer
