// The cloth on the graphics side: constant triangles and texture, vertices anew each frame.
#pragma once

#include <vector>

#include "render/gl_object.h"
#include "render/image.h"
#include "render/stage.h"
#include "weft/frame.h"

namespace weft {

/// The vertex buffers and the texture of a cloth.
class ClothMesh {
public:
    /// @throws Error (file) where the texture is larger than the driver takes.
    ClothMesh(const Surface& surface, const std::string& texture);

    /// Takes over positions and normals; normals are computed where the frame has none.
    /// @return the frame's bounds.
    Box update(const Frame& frame);
    void draw() const;

private:
    struct Vertex {
        glm::vec3 position, normal;
    };

    const Surface* surface_;
    std::vector<Vertex> vertices_;  ///< [vertex]
    std::vector<Vec3f> normals_;    ///< [particle]; only for frames without
    GlVertexArray vertex_array_;
    GlBuffer vertex_buffer_, uv_buffer_, index_buffer_;
    GlTexture texture_;
};

}  // namespace weft
