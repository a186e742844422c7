// Renderbuffers with samples, resolved by a blit.
#include "viewer/view_framebuffer.h"

#include <algorithm>
#include <array>

namespace weft::viewer {

namespace {

/// One sample is a plain buffer, which OpenGL calls 0.
int asked_for(int samples) {
    return samples > 1 ? samples : 0;
}

void store(const GlRenderbuffer& buffer, GLenum format, int samples, int width, int height) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, asked_for(samples), format, width, height);
}

}  // namespace

std::vector<int> ViewFramebuffer::offered_samples() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    std::vector<int> offered;
    const GlRenderbuffer buffer;
    for (const int wanted : std::array{4, 2, 1}) {
        store(buffer, GL_RGBA8, std::min(wanted, most), 16, 16);
        GLint made = 0;
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &made);
        made = std::max(made, 1);
        if (offered.empty() || made < offered.back()) offered.push_back(made);
    }
    return offered;
}

bool ViewFramebuffer::window_has_depth() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    GLint kind = GL_NONE, bits = 0;
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH,
                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &kind);
    if (kind == GL_NONE) return false;
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH,
                                          GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &bits);
    return bits >= 24;
}

void ViewFramebuffer::prepare(int width, int height, int samples) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    if (width == width_ && height == height_ && samples == samples_) return;
    store(colour_, GL_RGBA8, samples, width, height);
    store(depth_, GL_DEPTH_COMPONENT24, samples, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              colour_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    width_ = width;
    height_ = height;
    samples_ = samples;
}

void ViewFramebuffer::show(const ViewArea& area, int window_height) const {
    const int bottom = window_height - area.top - area.height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width_, height_, area.left, bottom, area.left + area.width,
                      bottom + area.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace weft::viewer
