#include "cloth/mesh_cloth.h"

#include <fmt/format.h>

#include <utility>

#include "cloth/mesh_check.h"
#include "cloth/mesh_findings.h"
#include "cloth/mesh_springs.h"
#include "cloth/mesh_surface.h"
#include "cloth/mesh_topology.h"
#include "cloth/mesh_weld.h"
#include "weft/error.h"

namespace weft {

namespace {

void check_corners_apart(const Mesh& mesh, const ParticleFace& face, const std::string& file) {
    const Mesh::Face& source = mesh.faces[face.source];
    for (std::uint32_t a = 0; a < face.corners; ++a)
        for (std::uint32_t b = a + 1; b < face.corners; ++b) {
            if (face.particle[a] != face.particle[b]) continue;
            const std::size_t number = face_number(mesh, face.source);
            const std::size_t first = vertex_number(mesh, source.position[a]);
            const std::size_t second = vertex_number(mesh, source.position[b]);
            if (first == second)
                throw file_error(file, fmt::format("two corners of face {} are the same vertex {}",
                                                   number, first));
            throw file_error(file, fmt::format("two corners of face {} are in the same place "
                                               "(vertices {} and {})",
                                               number, first, second));
        }
}

std::vector<ParticleFace> particle_faces(const Mesh& mesh, const MeshWeld& weld,
                                         const std::string& file) {
    std::vector<ParticleFace> faces;
    faces.reserve(mesh.faces.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        ParticleFace face;
        face.corners = static_cast<std::uint32_t>(mesh.faces[f].corners);
        face.source = f;
        for (std::size_t k = 0; k < face.corners; ++k)
            face.particle[k] = weld.vertex_particle[mesh.faces[f].position[k]];
        check_corners_apart(mesh, face, file);
        faces.push_back(face);
    }
    return faces;
}

/// Areas of the faces, exactly 0 for one without area.
std::vector<double> areas_of(const std::vector<ParticleFace>& faces,
                             const std::vector<Vec3d>& positions) {
    std::vector<double> areas;
    areas.reserve(faces.size());
    for (const ParticleFace& face : faces) {
        const double area = face_area(face, positions);
        areas.push_back(is_without_area(face, area, positions) ? 0.0 : area);
    }
    return areas;
}

}  // namespace

MeshCloth build_mesh_cloth(const Mesh& mesh, const std::string& file) {
    check_mesh(mesh, file);
    const MeshWeld weld = weld_vertices(mesh);
    MeshCloth cloth;
    cloth.rest_positions.reserve(weld.first_vertex.size());
    for (const std::uint32_t vertex : weld.first_vertex)
        cloth.rest_positions.push_back(mesh.positions[vertex]);
    const std::vector<Vec3d>& positions = cloth.rest_positions;

    std::vector<ParticleFace> faces = particle_faces(mesh, weld, file);
    const std::vector<std::uint32_t> twins = earliest_twins(faces, positions.size());
    std::erase_if(faces,
                  [&](const ParticleFace& face) { return twins[face.source] != face.source; });

    const EdgeTable table = find_edges(faces, positions.size());
    const std::vector<double> face_areas = areas_of(faces, positions);
    const std::vector<std::uint32_t> pieces = find_pieces(faces, positions.size());
    cloth.areas = particle_areas(faces, positions);
    cloth.springs = build_mesh_springs(faces, face_areas, table, positions);
    cloth.surface = build_mesh_surface(mesh, faces, positions);
    report_findings({mesh, weld, twins, faces, face_areas, table, pieces}, positions, cloth.report);
    return cloth;
}

}  // namespace weft
