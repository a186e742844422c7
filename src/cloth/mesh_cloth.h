// From a polygon mesh as a file has it to particles, springs and a surface to draw.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cloth/springs.h"
#include "weft/frame.h"
#include "weft/scene.h"

namespace weft {

/// What was found in a mesh; `weft check` prints it.
struct MeshReport {
    std::size_t vertices = 0, faces = 0, triangles = 0, quads = 0;  ///< polygons: their triangles
    std::size_t particles = 0;
    std::size_t welded_vertices = 0;     ///< at the place of an earlier vertex: same particle
    std::size_t unused_vertices = 0;     ///< in no face: left out
    std::size_t duplicate_faces = 0;     ///< same particles as an earlier face: left out
    std::size_t degenerate_faces = 0;    ///< without area: springs, but no air force
    std::size_t non_manifold_edges = 0;  ///< in three or more faces: no bend spring
    std::size_t border_edges = 0;        ///< in one face
    std::size_t pieces = 0;              ///< connected components
    std::vector<std::string> findings;   ///< a line for each finding, naming the first places
};

struct MeshCloth {
    std::vector<Vec3d> rest_positions;  ///< [particle], [m]
    std::vector<double> areas;          ///< [particle], a third of each triangle around it [m2]
    std::vector<Spring> springs;        ///< structural, then shear, then bend
    Surface surface;
    MeshReport report;
};

/// @param file names the mesh in errors.
/// @throws Error (file) for a mesh that cannot be a cloth: no faces, an index out of range, a
///         co-ordinate that is not finite, two corners of a face in one place.
MeshCloth build_mesh_cloth(const Mesh& mesh, const std::string& file);

}  // namespace weft
