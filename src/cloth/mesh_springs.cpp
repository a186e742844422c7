#include "cloth/mesh_springs.h"

#include <algorithm>
#include <cstddef>

namespace weft {

namespace {

/// Pairs to be joined, each with its share: a strip's area, or a width factor.
struct Joints {
    std::vector<ParticlePair> pairs;
    std::vector<double> shares;

    void add(std::uint32_t a, std::uint32_t b, double share) {
        pairs.push_back(ParticlePair::of(a, b));
        shares.push_back(share);
    }
};

/// The joints sorted, those of the same pair merged.
Joints merged(const Joints& joints, std::size_t particle_count) {
    Joints result;
    for (const std::uint32_t k : sorted_order(joints.pairs, particle_count)) {
        if (!result.pairs.empty() && result.pairs.back() == joints.pairs[k]) {
            result.shares.back() += joints.shares[k];
        } else {
            result.pairs.push_back(joints.pairs[k]);
            result.shares.push_back(joints.shares[k]);
        }
    }
    return result;
}

double edge_share(const ParticleFace& face, double area) {
    return face.corners == 4 ? 0.5 * area : area;
}

Spring spring_of_strip(ParticlePair pair, SpringKind kind, double area,
                       std::span<const Vec3d> positions) {
    const double rest_length = length(positions[pair.q] - positions[pair.p]);
    return {pair.p, pair.q, kind, rest_length, area / (rest_length * rest_length)};
}

Joints shear_joints(std::span<const ParticleFace> faces, std::span<const double> areas,
                    std::span<const Vec3d> positions) {
    Joints joints;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (faces[f].corners != 4) continue;
        for (std::size_t k = 0; k < 2; ++k) {
            const std::uint32_t a = faces[f].particle[k], b = faces[f].particle[k + 2];
            const Vec3d d = positions[b] - positions[a];
            joints.add(a, b, areas[f] > 0 ? dot(d, d) / (2.0 * areas[f]) : 0.0);
        }
    }
    return joints;
}

/// The pairs across one edge of two faces: from each end of it, the neighbours on either side.
void add_bend_joints(std::span<const ParticleFace> faces, std::span<const double> areas,
                     std::span<const EdgeUse> uses, Joints& joints) {
    const ParticleFace& f = faces[uses[0].face];
    const ParticleFace& g = faces[uses[1].face];
    const std::uint32_t fk = uses[0].corner, gk = uses[1].corner;
    const bool along = f.particle[fk] == g.particle[gk];  // both faces run the same way
    const std::uint32_t before_f = f.particle[f.previous(fk)];
    const std::uint32_t after_f = f.particle[f.next(f.next(fk))];
    const std::uint32_t before_g = g.particle[g.previous(gk)];
    const std::uint32_t after_g = g.particle[g.next(g.next(gk))];
    const ParticlePair first = ParticlePair::of(before_f, along ? before_g : after_g);
    const ParticlePair second = ParticlePair::of(after_f, along ? after_g : before_g);
    const double area = edge_share(f, areas[uses[0].face]) + edge_share(g, areas[uses[1].face]);
    const double share = first == second ? area : 0.5 * area;
    if (first.p != first.q) joints.add(first.p, first.q, share);
    if (first != second && second.p != second.q) joints.add(second.p, second.q, share);
}

Joints bend_joints(std::span<const ParticleFace> faces, std::span<const double> areas,
                   const EdgeTable& table) {
    Joints joints;
    for (const MeshEdge& edge : table.edges)
        if (edge.uses == 2) add_bend_joints(faces, areas, table.uses_of(edge), joints);
    return joints;
}

}  // namespace

std::vector<Spring> build_mesh_springs(std::span<const ParticleFace> faces,
                                       std::span<const double> areas, const EdgeTable& table,
                                       std::span<const Vec3d> positions) {
    std::vector<Spring> springs;
    for (const MeshEdge& edge : table.edges) {
        double area = 0.0;
        for (const EdgeUse& use : table.uses_of(edge))
            area += edge_share(faces[use.face], areas[use.face]);
        springs.push_back(spring_of_strip(edge.ends, SpringKind::structural, area, positions));
    }
    const Joints shear = merged(shear_joints(faces, areas, positions), positions.size());
    for (std::size_t k = 0; k < shear.pairs.size(); ++k) {
        const ParticlePair pair = shear.pairs[k];
        springs.push_back({pair.p, pair.q, SpringKind::shear,
                           length(positions[pair.q] - positions[pair.p]), shear.shares[k]});
    }
    const Joints bend = merged(bend_joints(faces, areas, table), positions.size());
    auto edge = table.edges.begin();
    for (std::size_t k = 0; k < bend.pairs.size(); ++k) {
        while (edge != table.edges.end() && edge->ends < bend.pairs[k]) ++edge;
        if (edge != table.edges.end() && edge->ends == bend.pairs[k]) continue;
        springs.push_back(
            spring_of_strip(bend.pairs[k], SpringKind::bend, bend.shares[k], positions));
    }
    return springs;
}

}  // namespace weft
