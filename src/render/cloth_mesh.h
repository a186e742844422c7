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
    /// @return whether they differ from those before.
    bool update(const Frame& frame);
    /// @param step every which row and column of a grid is drawn.
    /// @param quick with the nearest of the texture's sizes, not a blend that looks along slopes.
    void draw(std::uint32_t step, bool quick);
    [[nodiscard]] const Box& bounds() const { return bounds_; }  ///< of what update() took

private:
    struct Vertex {
        glm::vec3 position, normal;
    };

    void set_step(std::uint32_t step);

    const Surface* surface_;
    std::uint32_t step_ = 0;  ///< of what index_buffer_ holds
    GLsizei index_count_ = 0;
    bool filled_ = false;  ///< update() has been called
    Box bounds_;
    std::vector<Vertex> vertices_;  ///< [vertex]
    std::vector<Vec3f> normals_;    ///< [particle]; only for frames without
    GlVertexArray vertex_array_;
    GlBuffer vertex_buffer_, uv_buffer_, index_buffer_;
    GlTexture texture_;
    GlSampler quick_sampler_;
};

}  // namespace weft
