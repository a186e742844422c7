// Small meshes that several tests build cloths from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "cloth/mesh_cloth.h"
#include "weft/error.h"
#include "weft/scene.h"

namespace weft::testing {

inline Mesh::Face face_of(std::initializer_list<std::uint32_t> corners) {
    Mesh::Face face;
    face.corners = static_cast<int>(corners.size());
    std::size_t k = 0;
    for (const std::uint32_t corner : corners) {
        face.position.at(k) = corner;
        face.uv.at(k++) = corner;
    }
    return face;
}

inline Mesh mesh_of(std::vector<Vec3d> positions,
                    std::initializer_list<std::initializer_list<std::uint32_t>> faces) {
    Mesh mesh;
    mesh.positions = std::move(positions);
    for (const auto& corners : faces) mesh.faces.push_back(face_of(corners));
    return mesh;
}

/// The unit square in the xy plane, as corners in a ring from the origin.
inline std::vector<Vec3d> unit_square() {
    return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
}

/// A sheet of quads in the xy plane, particles numbered row by row, rows running downward.
inline Mesh grid_mesh(std::uint32_t columns, std::uint32_t rows, double dx, double dy) {
    Mesh mesh;
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            mesh.positions.push_back({i * dx, -(j * dy), 0.0});
            mesh.uvs.push_back({static_cast<float>(i) / static_cast<float>(columns - 1),
                                1.0f - static_cast<float>(j) / static_cast<float>(rows - 1)});
        }
    for (std::uint32_t j = 0; j + 1 < rows; ++j)
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t corner = j * columns + i;
            mesh.faces.push_back(
                face_of({corner, corner + columns, corner + columns + 1, corner + 1}));
        }
    return mesh;
}

inline MeshCloth cloth_of(const Mesh& mesh) {
    return build_mesh_cloth(mesh, "shirt.obj");
}

inline std::array<std::size_t, 3> spring_counts(const MeshCloth& cloth) {
    std::array<std::size_t, 3> counts{};
    for (const Spring& spring : cloth.springs) ++counts[static_cast<std::size_t>(spring.kind)];
    return counts;
}

/// @return null where there is none.
inline const Spring* find_spring(const MeshCloth& cloth, SpringKind kind, std::uint32_t p,
                                 std::uint32_t q) {
    for (const Spring& spring : cloth.springs)
        if (spring.kind == kind && spring.p == p && spring.q == q) return &spring;
    return nullptr;
}

/// The message of the file error that building the mesh ends in; empty if it does not.
inline std::string build_error(const Mesh& mesh) {
    try {
        cloth_of(mesh);
    } catch (const Error& error) {
        return error.kind() == ErrorKind::file ? error.what() : "not a file error";
    }
    return {};
}

}  // namespace weft::testing
