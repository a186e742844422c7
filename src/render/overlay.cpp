// Drawing lists of lines and points.
#include "render/overlay.h"

#include <algorithm>
#include <cstddef>

#include "render/shader_program.h"
#include "render/shaders.h"

namespace weft {

namespace {

// How far marks are drawn toward the eye, in near planes: less than two layers of cloth are apart,
// more than a line's half width hides on a slope.
constexpr float lift = 0.12F;
// Half of the pixels over which the edge of a line fades.
constexpr float half_fade = 0.5F;

static_assert(sizeof(OverlayVertex) == 16, "read as one texel of four 32-bit values");

/// Binds the target's rectangle and what both kinds of marks need.
void begin(const GlProgram& program, const Camera& camera, const DrawTarget& target,
           glm::vec2 sizes) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(target.left, target.bottom, target.width, target.height);
    glScissor(target.left, target.bottom, target.width, target.height);
    glEnable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(program.name());
    const auto place = [&](const char* name) { return glGetUniformLocation(program.name(), name); };
    const auto width = static_cast<float>(target.width), height = static_cast<float>(target.height);
    const glm::mat4 to_clip = camera.world_to_clip(width / height);
    glUniformMatrix4fv(place("to_clip"), 1, GL_FALSE, &to_clip[0][0]);
    const float near = camera.near_plane, far = camera.far_plane;
    glUniform2f(place("lift"), lift * near, -2.0F * far * near / (far - near));
    glUniform4f(place("pixels"), width, height, sizes.x, sizes.y);
}

void end() {
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace

Overlay::Overlay()
    : line_program_(make_program(shaders::mark, shaders::line_vertex, shaders::line_fragment)),
      thin_line_program_(
          make_program(shaders::mark, shaders::mark_vertex, shaders::thin_line_fragment)),
      point_program_(make_program(shaders::mark, shaders::mark_vertex, shaders::point_fragment)) {
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most_texels_);
    glBindVertexArray(mark_array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    glVertexAttribPointer(position_attribute, 3, GL_FLOAT, GL_FALSE, sizeof(OverlayVertex),
                          nullptr);
    // OpenGL wants the offset into the buffer as a pointer.
    glVertexAttribPointer(colour_attribute, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(OverlayVertex),
                          reinterpret_cast<const void*>(offsetof(OverlayVertex, colour)));
    glEnableVertexAttribArray(position_attribute);
    glEnableVertexAttribArray(colour_attribute);
    glBindVertexArray(0);
}

void Overlay::draw_lines(std::span<const OverlayVertex> lines, float width, const Camera& camera,
                         const DrawTarget& target) {
    if (lines.size() < 2) return;
    if (width <= 1.0F) return draw_thin_lines(lines, camera, target);
    begin(line_program_, camera, target, {0.5F * width, half_fade});
    glBindVertexArray(no_array_.name());
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(line_texture_unit));
    glBindTexture(GL_TEXTURE_BUFFER, ends_.name());
    // OpenGL promises no more than 65536 texels, though drivers have thousands of times that.
    const std::size_t most = static_cast<std::size_t>(most_texels_) / 2 * 2;
    for (std::size_t first = 0; first + 1 < lines.size(); first += most) {
        const auto part = lines.subspan(first, std::min(most, lines.size() - first));
        fill_buffer(GL_TEXTURE_BUFFER, vertices_, part, GL_STREAM_DRAW);
        glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, vertices_.name());
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(part.size() / 2 * 6));
    }
    end();
}

void Overlay::draw_thin_lines(std::span<const OverlayVertex> lines, const Camera& camera,
                              const DrawTarget& target) {
    begin(thin_line_program_, camera, target, {1.0F, 0.0F});
    fill_buffer(GL_ARRAY_BUFFER, vertices_, lines, GL_STREAM_DRAW);
    glBindVertexArray(mark_array_.name());
    glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(lines.size() / 2 * 2));
    end();
}

void Overlay::draw_points(std::span<const OverlayVertex> points, float size, const Camera& camera,
                          const DrawTarget& target) {
    if (points.empty()) return;
    begin(point_program_, camera, target, {size, 0.0F});
    glEnable(GL_PROGRAM_POINT_SIZE);
    fill_buffer(GL_ARRAY_BUFFER, vertices_, points, GL_STREAM_DRAW);
    glBindVertexArray(mark_array_.name());
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points.size()));
    glDisable(GL_PROGRAM_POINT_SIZE);
    end();
}

}  // namespace weft
