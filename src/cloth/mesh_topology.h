// How the faces of a welded mesh hang together: pairs of particles, edges, pieces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/vec3.h"

namespace weft {

/// A triangle or quad of particles, all different.
struct ParticleFace {
    std::array<std::uint32_t, 4> particle{};
    std::uint32_t corners = 3;  ///< 3 or 4
    std::uint32_t source = 0;   ///< the face of the Mesh that it is

    [[nodiscard]] std::uint32_t next(std::uint32_t corner) const {
        return corner + 1 == corners ? 0 : corner + 1;
    }
    [[nodiscard]] std::uint32_t previous(std::uint32_t corner) const {
        return corner == 0 ? corners - 1 : corner - 1;
    }
};

/// Two particles, p < q.
struct ParticlePair {
    std::uint32_t p = 0, q = 0;

    static ParticlePair of(std::uint32_t a, std::uint32_t b) {
        return a < b ? ParticlePair{a, b} : ParticlePair{b, a};
    }
    friend constexpr auto operator<=>(const ParticlePair&, const ParticlePair&) = default;
};

/// Indices of `pairs` in the order of (p, q), equal pairs in the order given.
std::vector<std::uint32_t> sorted_order(std::span<const ParticlePair> pairs,
                                        std::size_t particle_count);

/// One face at an edge, which it runs along from corner to next(corner).
struct EdgeUse {
    std::uint32_t face = 0;
    std::uint32_t corner = 0;
};

struct MeshEdge {
    ParticlePair ends;
    std::uint32_t first_use = 0, uses = 0;  ///< a range of EdgeTable::uses, by face number
};

/// Every edge once, sorted by its ends.
struct EdgeTable {
    std::vector<MeshEdge> edges;
    std::vector<EdgeUse> uses;

    [[nodiscard]] std::span<const EdgeUse> uses_of(const MeshEdge& edge) const {
        return std::span(uses).subspan(edge.first_use, edge.uses);
    }
};
EdgeTable find_edges(std::span<const ParticleFace> faces, std::size_t particle_count);

/// For each face the earliest face on the same particles: itself, if it is the first.
std::vector<std::uint32_t> earliest_twins(std::span<const ParticleFace> faces,
                                          std::size_t particle_count);

/// The lowest particle of every connected piece, rising. Each particle is in a face.
std::vector<std::uint32_t> find_pieces(std::span<const ParticleFace> faces,
                                       std::size_t particle_count);

/// The two triangles of a quad, or the one of a triangle, as corners of the face.
struct FaceTriangles {
    std::array<std::array<std::uint32_t, 3>, 2> corner{};
    std::size_t count = 1;
};

/// Cuts a quad along the diagonal from corner 0 to 2, save where the other one clearly makes better
/// triangles: a quad that is not convex, or has three corners in a line.
FaceTriangles cut_face(const ParticleFace& face, std::span<const Vec3d> positions);

/// Area of the triangles of cut_face() [m2].
double face_area(const ParticleFace& face, std::span<const Vec3d> positions);

/// Whether the area is nothing beside the square of the face's longest side.
bool is_without_area(const ParticleFace& face, double area, std::span<const Vec3d> positions);

}  // namespace weft
