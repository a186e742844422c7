// Buffers and texture of a cloth.
#include "render/cloth_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "render/grid_indices.h"
#include "render/shader_program.h"
#include "weft/error.h"

namespace weft {

namespace {

bool leaves_unit_square(const Surface& surface) {
    return std::any_of(surface.uvs.begin(), surface.uvs.end(), [](const auto& uv) {
        return uv[0] < 0.0F || uv[0] > 1.0F || uv[1] < 0.0F || uv[1] > 1.0F;
    });
}

void set_up_sampler(const GlSampler& sampler, bool repeat) {
    const GLint wrap = repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glSamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_S, wrap);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_T, wrap);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void upload_texture(const GlTexture& texture, const std::string& name, bool repeat) {
    const Image image = load_texture(name);
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (image.width > limit || image.height > limit) {
        throw file_error(name, fmt::format("the texture is {} x {} pixels; OpenGL takes {} here",
                                           image.width, image.height, limit));
    }
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(cloth_texture_unit));
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image.width, image.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, image.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    // A texture that is shown once must not bleed from one edge into the opposite one.
    const GLint wrap = repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 4.0F);
}

}  // namespace

ClothMesh::ClothMesh(const Surface& surface, const std::string& texture)
    : surface_(&surface), vertices_(surface.vertex_count()) {
    const bool repeat = leaves_unit_square(surface);
    upload_texture(texture_, texture, repeat);
    set_up_sampler(quick_sampler_, repeat);
    glBindVertexArray(vertex_array_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_.name());
    // OpenGL counts v from the first row given, which is the top of an Image; Surface counts
    // upward.
    std::vector<std::array<float, 2>> uvs = surface.uvs;
    for (auto& uv : uvs) uv[1] = 1.0F - uv[1];
    fill_buffer(GL_ARRAY_BUFFER, uv_buffer_, uvs, GL_STATIC_DRAW);
    glVertexAttribPointer(colour_attribute, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer_.name());
    glVertexAttribPointer(position_attribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    // OpenGL wants the offset into the buffer as a pointer.
    glVertexAttribPointer(normal_attribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offsetof(Vertex, normal)));
    for (const GLuint attribute : {position_attribute, normal_attribute, colour_attribute})
        glEnableVertexAttribArray(attribute);
    glBindVertexArray(0);
}

bool ClothMesh::update(const Frame& frame) {
    std::span<const Vec3f> normals = frame.normals;
    if (normals.size() != frame.positions.size()) {
        normals_.resize(frame.positions.size());
        compute_normals(*surface_, frame.positions, normals_);
        normals = normals_;
    }
    bool changed = !filled_;
    for (std::uint32_t vertex = 0; vertex < vertices_.size(); ++vertex) {
        const std::uint32_t particle = surface_->particle(vertex);
        const glm::vec3 position = to_glm(frame.positions[particle]);
        const Vec3f normal = normals[particle];
        const Vertex taken{position, {normal.x, normal.y, normal.z}};
        changed = changed || taken.position != vertices_[vertex].position ||
                  taken.normal != vertices_[vertex].normal;
        vertices_[vertex] = taken;
        bounds_ = vertex == 0 ? Box{position, position} : bounds_.grown_to(position);
    }
    if (changed) fill_buffer(GL_ARRAY_BUFFER, vertex_buffer_, vertices_, GL_STREAM_DRAW);
    filled_ = true;
    return changed;
}

void ClothMesh::set_step(std::uint32_t step) {
    if (step == step_) return;
    const auto triangles = triangles_of(*surface_, step);
    glBindVertexArray(vertex_array_.name());  // which holds the buffer of indices
    fill_buffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_, triangles, GL_STATIC_DRAW);
    index_count_ = static_cast<GLsizei>(3 * triangles.size());
    step_ = step;
}

void ClothMesh::draw(std::uint32_t step, bool quick) {
    set_step(step);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(cloth_texture_unit));
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glBindSampler(static_cast<GLuint>(cloth_texture_unit), quick ? quick_sampler_.name() : 0);
    glBindVertexArray(vertex_array_.name());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    glBindSampler(static_cast<GLuint>(cloth_texture_unit), 0);
}

}  // namespace weft
