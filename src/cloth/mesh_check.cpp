#include "cloth/mesh_check.h"

#include <fmt/format.h>

#include <cmath>

#include "weft/error.h"

namespace weft {

namespace {

// Beyond it squares and volumes of lengths lose the digits that welding and areas need.
constexpr double largest_coordinate = 1e9;
// Indices of face corners and of corner pairs are 32 bits wide.
constexpr std::size_t most_faces = std::size_t{1} << 29;
constexpr std::size_t most_vertices = (std::size_t{1} << 32) - 2;

std::size_t counted(const Mesh& mesh, std::size_t index) {
    return index + static_cast<std::size_t>(mesh.first_number);
}

void check_sizes(const Mesh& mesh, const std::string& file) {
    if (mesh.faces.empty()) throw file_error(file, "the mesh has no faces");
    if (mesh.faces.size() > most_faces || mesh.positions.size() > most_vertices)
        throw file_error(
            file, fmt::format("{} vertices and {} faces are too many: at most {} and {}",
                              mesh.positions.size(), mesh.faces.size(), most_vertices, most_faces));
    if (!mesh.source_faces.empty() && mesh.source_faces.size() != mesh.faces.size())
        throw file_error(file, fmt::format("source_faces has {} entries for {} faces",
                                           mesh.source_faces.size(), mesh.faces.size()));
}

void check_positions(const Mesh& mesh, const std::string& file) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3d p = mesh.positions[v];
        if (!is_finite(p))
            throw file_error(file, fmt::format("vertex {} has a co-ordinate that is not finite: "
                                               "({}, {}, {})",
                                               counted(mesh, v), p.x, p.y, p.z));
        if (std::fmax(std::fmax(std::fabs(p.x), std::fabs(p.y)), std::fabs(p.z)) >
            largest_coordinate)
            throw file_error(file,
                             fmt::format("vertex {} lies at ({}, {}, {}): co-ordinates up to "
                                         "{} m are allowed",
                                         counted(mesh, v), p.x, p.y, p.z, largest_coordinate));
    }
}

void check_uvs(const Mesh& mesh, const std::string& file) {
    for (std::size_t v = 0; v < mesh.uvs.size(); ++v)
        if (!std::isfinite(mesh.uvs[v][0]) || !std::isfinite(mesh.uvs[v][1]))
            throw file_error(file, fmt::format("texture vertex {} has a co-ordinate that is not "
                                               "finite: ({}, {})",
                                               counted(mesh, v), mesh.uvs[v][0], mesh.uvs[v][1]));
}

void check_face(const Mesh& mesh, std::size_t f, const std::string& file) {
    const Mesh::Face& face = mesh.faces[f];
    if (face.corners != 3 && face.corners != 4)
        throw file_error(file, fmt::format("face {} has {} corners: 3 or 4 are allowed",
                                           face_number(mesh, f), face.corners));
    for (std::size_t k = 0; k < static_cast<std::size_t>(face.corners); ++k) {
        if (face.position[k] >= mesh.positions.size())
            throw file_error(file,
                             fmt::format("face {} names vertex {}, but there are {} vertices",
                                         face_number(mesh, f), counted(mesh, face.position[k]),
                                         mesh.positions.size()));
        if (!mesh.uvs.empty() && face.uv[k] >= mesh.uvs.size())
            throw file_error(file, fmt::format("face {} names texture vertex {}, but there are {}",
                                               face_number(mesh, f), counted(mesh, face.uv[k]),
                                               mesh.uvs.size()));
    }
}

}  // namespace

std::size_t vertex_number(const Mesh& mesh, std::size_t vertex) {
    return counted(mesh, vertex);
}

std::size_t face_number(const Mesh& mesh, std::size_t face) {
    return counted(mesh, mesh.source_faces.empty() ? face : mesh.source_faces[face]);
}

void check_mesh(const Mesh& mesh, const std::string& file) {
    check_sizes(mesh, file);
    check_positions(mesh, file);
    check_uvs(mesh, file);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) check_face(mesh, f, file);
}

}  // namespace weft
