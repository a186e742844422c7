// A solid on the graphics side.
#pragma once

#include "render/gl_object.h"
#include "render/solid.h"

namespace weft {

class SolidMesh {
public:
    SolidMesh();

    void set(const Solid& solid);  ///< replaces what was there
    void draw() const;

private:
    GlVertexArray vertex_array_;
    GlBuffer vertices_, indices_;
    GLsizei index_count_ = 0;
};

}  // namespace weft
