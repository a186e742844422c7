// Whether two meshes are the same cloth.
#pragma once

#include <algorithm>

#include "weft/scene.h"

namespace weft {

/// How faces are numbered in messages aside: a file that was read again gives the same mesh.
inline bool same_mesh(const Mesh& a, const Mesh& b) {
    const auto same_face = [](const Mesh::Face& f, const Mesh::Face& g) {
        return f.position == g.position && f.uv == g.uv && f.corners == g.corners;
    };
    return a.positions == b.positions && a.uvs == b.uvs &&
           std::equal(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(), same_face);
}

}  // namespace weft
