// Vertices in the same place are one particle.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cloth/mesh_examples.h"
#include "cloth/mesh_weld.h"

namespace weft::testing {
namespace {

/// Two unit squares side by side, the shared side doubled: vertices 4 and 7 lie on 1 and 2.
Mesh doubled_seam() {
    return mesh_of(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}},
        {{0, 1, 2, 3}, {4, 5, 6, 7}});
}

TEST(MeshWeld, SeamBecomesOneEdge) {
    const MeshCloth cloth = cloth_of(doubled_seam());
    ASSERT_EQ(cloth.rest_positions.size(), 6u);
    EXPECT_EQ(spring_counts(cloth), (std::array<std::size_t, 3>{7, 4, 2}));
    EXPECT_EQ(cloth.report.welded_vertices, 2u);
    EXPECT_EQ(cloth.report.pieces, 1u);
    EXPECT_EQ(cloth.report.border_edges, 6u);
    EXPECT_EQ(cloth.report.findings[0],
              "2 vertices are in the place of an earlier one: welded to it; the first is vertex 5 "
              "(with vertex 2)");
}

TEST(MeshWeld, ParticlesStandInTheOrderOfTheirFirstVertices) {
    const MeshWeld weld = weld_vertices(doubled_seam());
    EXPECT_EQ(weld.vertex_particle, (std::vector<std::uint32_t>{0, 1, 2, 3, 1, 4, 5, 2}));
    EXPECT_EQ(weld.first_vertex, (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 6}));
}

TEST(MeshWeld, ParticleKeepsThePlaceOfItsFirstVertex) {
    Mesh mesh = doubled_seam();
    mesh.positions[4].x += 1e-6;  // tolerance sqrt(5) * 1e-6
    EXPECT_EQ(cloth_of(mesh).rest_positions[1], (Vec3d{1, 0, 0}));
}

TEST(MeshWeld, ToleranceIsAMillionthOfTheDiagonal) {
    // A box of 3 x 4 has the diagonal 5 and so the tolerance 5e-6.
    const auto particles = [](Vec3d offset) {
        const Vec3d corner{3, 0, 0};
        return cloth_of(mesh_of({{0, 0, 0}, corner, {0, 4, 0}, corner + offset, {3, 4, 0}},
                                {{0, 1, 2}, {3, 4, 2}}))
            .rest_positions.size();
    };
    EXPECT_EQ(particles({-4e-6, 0, 0}), 4u);
    EXPECT_EQ(particles({0, 4e-6, 0}), 4u);
    EXPECT_EQ(particles({0, 0, 4.9e-6}), 4u);
    EXPECT_EQ(particles({-6e-6, 0, 0}), 5u);
    EXPECT_EQ(particles({-4e-6, 4e-6, 0}), 5u);
}

TEST(MeshWeld, ToleranceFollowsTheSizeOfTheMesh) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        Mesh mesh = doubled_seam();
        mesh.positions[4].x += 1e-6;
        mesh.positions[7].x += 1e-5;
        for (Vec3d& p : mesh.positions) p *= scale;
        EXPECT_EQ(cloth_of(mesh).rest_positions.size(), 7u) << scale;
    }
}

TEST(MeshWeld, VertexInNoFaceIsLeftOutAndDoesNotCount) {
    Mesh mesh = doubled_seam();
    mesh.positions.insert(mesh.positions.begin(), {1e6, 1e6, 1e6});  // would stretch the tolerance
    mesh.positions.push_back({0, 0, 0});
    for (Mesh::Face& face : mesh.faces)
        for (std::uint32_t& vertex : face.position) ++vertex;
    const MeshCloth cloth = cloth_of(mesh);
    EXPECT_EQ(cloth.rest_positions.size(), 6u);
    EXPECT_EQ(cloth.report.unused_vertices, 2u);
    EXPECT_EQ(cloth.report.welded_vertices, 2u);
    EXPECT_EQ(cloth.report.findings[1],
              "2 vertices are in no face: left out; the first is vertex 1");
}

TEST(MeshWeld, AgreesWithComparingEveryPair) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0.0, 1.0), near(-1.5e-6, 1.5e-6);
    Mesh mesh = mesh_of({{0, 0, 0}, {1, 1, 1}}, {});
    for (int cluster = 0; cluster < 200; ++cluster) {
        const Vec3d centre{place(random), place(random), place(random)};
        for (int k = 0; k < 4; ++k)
            mesh.positions.push_back(centre + Vec3d{near(random), near(random), near(random)});
    }
    for (std::uint32_t v = 0; v + 2 < mesh.positions.size(); ++v)
        mesh.faces.push_back(face_of({v, v + 1, v + 2}));
    const double tolerance = 1e-6 * std::sqrt(3.0);
    const MeshWeld weld = weld_vertices(mesh);
    std::vector<Vec3d> particles;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        std::uint32_t expected = 0;
        while (expected < particles.size() &&
               length(particles[expected] - mesh.positions[v]) > tolerance)
            ++expected;
        if (expected == particles.size()) particles.push_back(mesh.positions[v]);
        EXPECT_EQ(weld.vertex_particle[v], expected) << v;
    }
    EXPECT_EQ(weld.first_vertex.size(), particles.size());
    EXPECT_GT(weld.welded_vertices, 100u);
    EXPECT_GT(particles.size(), 250u);
}

}  // namespace
}  // namespace weft::testing
