#include "cloth/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace weft {

namespace {

// A face narrower than this part of its longest side is a line.
constexpr double least_area_ratio = 1e-9;
// The diagonal 1-3 must be this much better, so that rounding never chooses between equals.
constexpr double clearly_better = 1.01;

/// The smaller of the two triangles on either side of a diagonal, over the diagonal squared;
/// negative where a triangle is turned over against the quad.
double worst_triangle(Vec3d a, Vec3d b, Vec3d c, Vec3d d, Vec3d quad_normal) {
    const Vec3d diagonal = c - a;
    const double first = dot(cross(b - a, diagonal), quad_normal);
    const double second = dot(cross(diagonal, d - a), quad_normal);
    const double squared = dot(diagonal, diagonal);
    return std::min(first, second) / (squared > 0 ? squared : 1.0);
}

std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t p) {
    while (parent[p] != p) p = parent[p] = parent[parent[p]];
    return p;
}

/// The particles of a face, rising; a triangle's end in a number that no particle has.
std::array<std::uint32_t, 4> sorted_particles(const ParticleFace& face) {
    std::array<std::uint32_t, 4> p = face.particle;
    if (face.corners == 3) p[3] = 0xffffffff;
    const auto put_in_order = [&p](std::size_t a, std::size_t b) {
        if (p[b] < p[a]) std::swap(p[a], p[b]);
    };
    put_in_order(0, 1);
    put_in_order(2, 3);
    put_in_order(0, 2);
    put_in_order(1, 3);
    put_in_order(1, 2);
    return p;
}

}  // namespace

std::vector<std::uint32_t> sorted_order(std::span<const ParticlePair> pairs,
                                        std::size_t particle_count) {
    std::vector<std::uint32_t> start(particle_count + 1, 0);
    for (const ParticlePair pair : pairs) ++start[pair.p + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::uint32_t> order(pairs.size());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::uint32_t k = 0; k < pairs.size(); ++k) order[next[pairs[k].p]++] = k;
    for (std::size_t p = 0; p < particle_count; ++p)
        std::sort(order.begin() + start[p], order.begin() + start[p + 1],
                  [&](std::uint32_t a, std::uint32_t b) {
                      return pairs[a].q != pairs[b].q ? pairs[a].q < pairs[b].q : a < b;
                  });
    return order;
}

EdgeTable find_edges(std::span<const ParticleFace> faces, std::size_t particle_count) {
    std::vector<ParticlePair> pairs;
    std::vector<EdgeUse> sides;
    pairs.reserve(4 * faces.size());
    sides.reserve(4 * faces.size());
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (std::uint32_t k = 0; k < faces[f].corners; ++k) {
            pairs.push_back(
                ParticlePair::of(faces[f].particle[k], faces[f].particle[faces[f].next(k)]));
            sides.push_back({f, k});
        }
    EdgeTable table;
    table.uses.reserve(sides.size());
    for (const std::uint32_t k : sorted_order(pairs, particle_count)) {
        if (table.edges.empty() || table.edges.back().ends != pairs[k])
            table.edges.push_back({pairs[k], static_cast<std::uint32_t>(table.uses.size()), 0});
        ++table.edges.back().uses;
        table.uses.push_back(sides[k]);
    }
    return table;
}

std::vector<std::uint32_t> earliest_twins(std::span<const ParticleFace> faces,
                                          std::size_t particle_count) {
    // Twins have the same two lowest particles; among faces that do, the others decide.
    std::vector<std::array<std::uint32_t, 4>> keys(faces.size());
    std::vector<ParticlePair> lowest(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        keys[f] = sorted_particles(faces[f]);
        lowest[f] = {keys[f][0], keys[f][1]};
    }
    std::vector<std::uint32_t> order = sorted_order(lowest, particle_count);
    for (auto first = order.begin(); first != order.end();) {
        auto last = first;
        while (last != order.end() && lowest[*last] == lowest[*first]) ++last;
        std::sort(first, last, [&](std::uint32_t a, std::uint32_t b) {
            return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
        });
        first = last;
    }
    std::vector<std::uint32_t> twins(faces.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && keys[order[k]] == keys[order[k - 1]];
        twins[order[k]] = same ? twins[order[k - 1]] : order[k];
    }
    return twins;
}

std::vector<std::uint32_t> find_pieces(std::span<const ParticleFace> faces,
                                       std::size_t particle_count) {
    std::vector<std::uint32_t> parent(particle_count);
    std::iota(parent.begin(), parent.end(), 0u);
    for (const ParticleFace& face : faces)
        for (std::uint32_t k = 1; k < face.corners; ++k) {
            const std::uint32_t a = find_root(parent, face.particle[0]);
            const std::uint32_t b = find_root(parent, face.particle[k]);
            parent[std::max(a, b)] = std::min(a, b);
        }
    std::vector<std::uint32_t> pieces;
    for (std::uint32_t p = 0; p < particle_count; ++p)
        if (parent[p] == p) pieces.push_back(p);
    return pieces;
}

FaceTriangles cut_face(const ParticleFace& face, std::span<const Vec3d> positions) {
    if (face.corners == 3) return {{{{0, 1, 2}}}, 1};
    const Vec3d a = positions[face.particle[0]], b = positions[face.particle[1]];
    const Vec3d c = positions[face.particle[2]], d = positions[face.particle[3]];
    const Vec3d normal = cross(c - a, d - b);
    const double along_02 = worst_triangle(a, b, c, d, normal);
    const double along_13 = worst_triangle(b, c, d, a, normal);
    if (along_13 > 0 && along_13 > clearly_better * along_02) return {{{{0, 1, 3}, {1, 2, 3}}}, 2};
    return {{{{0, 1, 2}, {0, 2, 3}}}, 2};
}

double face_area(const ParticleFace& face, std::span<const Vec3d> positions) {
    const FaceTriangles triangles = cut_face(face, positions);
    double area = 0.0;
    for (std::size_t t = 0; t < triangles.count; ++t) {
        const Vec3d a = positions[face.particle[triangles.corner[t][0]]];
        const Vec3d b = positions[face.particle[triangles.corner[t][1]]];
        const Vec3d c = positions[face.particle[triangles.corner[t][2]]];
        area += 0.5 * length(cross(b - a, c - a));
    }
    return area;
}

bool is_without_area(const ParticleFace& face, double area, std::span<const Vec3d> positions) {
    double longest = 0.0;
    for (std::uint32_t k = 0; k < face.corners; ++k) {
        const Vec3d side = positions[face.particle[face.next(k)]] - positions[face.particle[k]];
        longest = std::max(longest, dot(side, side));
    }
    return area <= least_area_ratio * longest;
}

}  // namespace weft
