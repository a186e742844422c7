// Buffers of a solid.
#include "render/solid_mesh.h"

#include <cstddef>

#include "render/shader_program.h"

namespace weft {

SolidMesh::SolidMesh() {
    glBindVertexArray(vertex_array_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    const auto attribute = [](GLuint location, std::size_t offset) {
        // OpenGL wants the offset into the buffer as a pointer.
        glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(SolidVertex),
                              reinterpret_cast<const void*>(offset));
        glEnableVertexAttribArray(location);
    };
    attribute(position_attribute, offsetof(SolidVertex, position));
    attribute(normal_attribute, offsetof(SolidVertex, normal));
    attribute(colour_attribute, offsetof(SolidVertex, colour));
    glBindVertexArray(0);
}

void SolidMesh::set(const Solid& solid) {
    index_count_ = static_cast<GLsizei>(solid.indices.size());
    if (index_count_ == 0) return;
    glBindVertexArray(vertex_array_.name());  // which holds the buffer of indices
    fill_buffer(GL_ELEMENT_ARRAY_BUFFER, indices_, solid.indices, GL_STREAM_DRAW);
    fill_buffer(GL_ARRAY_BUFFER, vertices_, solid.vertices, GL_STREAM_DRAW);
    glBindVertexArray(0);
}

void SolidMesh::draw() const {
    if (index_count_ == 0) return;
    glBindVertexArray(vertex_array_.name());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace weft
