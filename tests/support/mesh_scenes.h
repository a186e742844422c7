// Scenes of meshes: grids in random order, tubes, fans.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "support/cloth_scenes.h"

namespace weft::test {

/// 0 ... count - 1 in an order that the seed makes.
inline std::vector<std::uint32_t> random_order(std::size_t count, std::uint64_t seed) {
    std::vector<std::uint32_t> order(count);
    for (std::size_t n = 0; n < count; ++n) order[n] = static_cast<std::uint32_t>(n);
    for (std::size_t n = count; n > 1; --n) {
        const double u = random_uniform(seed, 0, n);
        std::swap(order[n - 1], order[static_cast<std::size_t>(u * static_cast<double>(n))]);
    }
    return order;
}

/// The mesh with vertices and faces in random order.
/// @return the new number of every vertex.
inline std::vector<std::uint32_t> shuffle(Mesh& mesh, std::uint64_t seed) {
    const std::vector<std::uint32_t> number = random_order(mesh.positions.size(), seed);
    const Mesh old = mesh;
    for (std::size_t p = 0; p < number.size(); ++p) mesh.positions[number[p]] = old.positions[p];
    const std::vector<std::uint32_t> faces = random_order(old.faces.size(), seed + 1);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Mesh::Face& face = mesh.faces[faces[f]] = old.faces[f];
        for (std::uint32_t& corner : face.position) {
            if (corner < number.size()) corner = number[corner];
        }
    }
    return number;
}

/// A sheet of quads, or of triangles cut either way in turn, `dx` a cell.
inline Mesh sheet_mesh(std::uint32_t columns, std::uint32_t rows, double dx, bool triangles) {
    Mesh mesh;
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i)
            mesh.positions.push_back({i * dx, -(j * dx), 0});
    }
    const auto add = [&](std::array<std::uint32_t, 4> corners, int count) {
        Mesh::Face face;
        face.position = corners;
        face.corners = count;
        mesh.faces.push_back(face);
    };
    for (std::uint32_t j = 0; j + 1 < rows; ++j) {
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = j * columns + i, b = a + columns, c = b + 1, d = a + 1;
            if (!triangles) {
                add({a, b, c, d}, 4);
            } else if ((i + j) % 2 == 0) {
                add({a, b, c, 0}, 3);
                add({a, c, d, 0}, 3);
            } else {
                add({a, b, d, 0}, 3);
                add({b, c, d, 0}, 3);
            }
        }
    }
    return mesh;
}

/// A tube of quads around the y axis, closed by a fan of triangles on top: the fan's middle has
/// `around` neighbours.
inline Mesh tube_mesh(std::uint32_t around, std::uint32_t rings, double dx) {
    Mesh mesh;
    const double radius = around * dx / (2 * std::numbers::pi);
    for (std::uint32_t j = 0; j < rings; ++j) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            mesh.positions.push_back(
                {radius * std::sin(angle), -(j * dx), radius * std::cos(angle)});
        }
    }
    mesh.positions.push_back({0.0, 0.4 * radius, 0.0});
    for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t next = (i + 1) % around;
        Mesh::Face cap;
        cap.position = {i, next, rings * around, 0};
        cap.corners = 3;
        mesh.faces.push_back(cap);
        for (std::uint32_t j = 0; j + 1 < rings; ++j) {
            const std::uint32_t above = j * around, below = above + around;
            Mesh::Face quad;
            quad.position = {above + i, below + i, below + next, above + next};
            quad.corners = 4;
            mesh.faces.push_back(quad);
        }
    }
    return mesh;
}

/// bare_sheet() with a mesh for a cloth.
inline SceneDescription mesh_scene(Mesh mesh) {
    SceneDescription scene = bare_sheet(2, 2);
    scene.cloth.mesh = std::make_shared<Mesh>(std::move(mesh));
    scene.cloth.mesh_path = "mesh.obj";
    return scene;
}

}  // namespace weft::test
