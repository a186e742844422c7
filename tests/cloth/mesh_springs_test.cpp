// Edges and springs of known meshes.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "cloth/mesh_examples.h"

namespace weft::testing {
namespace {

using Counts = std::array<std::size_t, 3>;

/// Vertices - edges + faces.
long euler_characteristic(const MeshCloth& cloth) {
    return static_cast<long>(cloth.rest_positions.size()) -
           static_cast<long>(spring_counts(cloth)[0]) +
           static_cast<long>(cloth.surface.faces.size());
}

Mesh tetrahedron() {
    return mesh_of({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                   {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

Mesh octahedron() {
    return mesh_of(
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

Mesh cube() {
    return mesh_of(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

/// A band of triangles closed into a ring of `columns`, two rows high.
Mesh open_cylinder(std::uint32_t columns) {
    Mesh mesh;
    for (std::uint32_t j = 0; j < 3; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const double angle = 2 * M_PI * i / columns;
            mesh.positions.push_back({std::cos(angle), 0.5 * j, std::sin(angle)});
        }
    for (std::uint32_t j = 0; j < 2; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = j * columns + i, b = j * columns + (i + 1) % columns;
            mesh.faces.push_back(face_of({a, b, b + columns}));
            mesh.faces.push_back(face_of({a, b + columns, a + columns}));
        }
    return mesh;
}

TEST(MeshSprings, EulerCharacteristicIsTwoOnSpheres) {
    EXPECT_EQ(euler_characteristic(cloth_of(tetrahedron())), 2);
    EXPECT_EQ(euler_characteristic(cloth_of(octahedron())), 2);
    EXPECT_EQ(euler_characteristic(cloth_of(cube())), 2);
}

TEST(MeshSprings, EulerCharacteristicIsOneOnASheetAndZeroOnARing) {
    EXPECT_EQ(euler_characteristic(cloth_of(grid_mesh(7, 5, 1, 1))), 1);
    const MeshCloth ring = cloth_of(open_cylinder(12));
    EXPECT_EQ(euler_characteristic(ring), 0);
    EXPECT_EQ(ring.report.border_edges, 24u);
    EXPECT_EQ(spring_counts(ring), (Counts{84, 0, 60}));  // bend: each of the 60 inner edges
}

TEST(MeshSprings, NoBendSpringWhereAnEdgeJoinsTheSameTwo) {
    EXPECT_EQ(spring_counts(cloth_of(tetrahedron())), (Counts{6, 0, 0}));
}

TEST(MeshSprings, BendSpringsFoundFromSeveralEdgesAreOne) {
    const MeshCloth cloth = cloth_of(octahedron());
    EXPECT_EQ(spring_counts(cloth), (Counts{12, 0, 3}));
    // Four edges give each axis the whole area of their two triangles, sqrt(3)/2 each; L = 2.
    for (const std::uint32_t p : {0u, 2u, 4u})
        EXPECT_NEAR(find_spring(cloth, SpringKind::bend, p, p + 1)->width_factor, std::sqrt(3.0),
                    1e-14);
}

TEST(MeshSprings, CubeBendsAcrossItsFaceDiagonals) {
    const MeshCloth cloth = cloth_of(cube());
    EXPECT_EQ(spring_counts(cloth), (Counts{12, 12, 12}));
    for (const Spring& spring : cloth.springs) {
        if (spring.kind != SpringKind::bend) continue;
        EXPECT_NE(find_spring(cloth, SpringKind::shear, spring.p, spring.q), nullptr);
        EXPECT_NEAR(spring.width_factor, 0.5, 1e-15);  // two edges, half a face each; L^2 = 2
    }
}

TEST(MeshSprings, TwoTrianglesBendAcrossTheirEdge) {
    const MeshCloth cloth = cloth_of(mesh_of(unit_square(), {{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(spring_counts(cloth), (Counts{5, 0, 1}));
    const Spring* bend = find_spring(cloth, SpringKind::bend, 1, 3);
    ASSERT_NE(bend, nullptr);
    EXPECT_NEAR(bend->rest_length, std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(bend->width_factor, 0.5, 1e-15);
    EXPECT_NEAR(find_spring(cloth, SpringKind::structural, 0, 2)->width_factor, 0.5, 1e-15);
    EXPECT_NEAR(find_spring(cloth, SpringKind::structural, 0, 1)->width_factor, 0.5, 1e-15);
}

TEST(MeshSprings, TriangleBesideAQuadGivesTwoBendSprings) {
    auto positions = unit_square();
    positions.push_back({2, 0.5, 0});
    const MeshCloth cloth = cloth_of(mesh_of(positions, {{0, 1, 2, 3}, {1, 4, 2}}));
    EXPECT_EQ(spring_counts(cloth), (Counts{6, 2, 2}));
    EXPECT_EQ(cloth.report.triangles, 1u);
    EXPECT_EQ(cloth.report.quads, 1u);
    EXPECT_NEAR(find_spring(cloth, SpringKind::structural, 1, 2)->width_factor, 1.0, 1e-15);
    EXPECT_NEAR(find_spring(cloth, SpringKind::structural, 1, 4)->width_factor, 0.4, 1e-15);
    EXPECT_NEAR(find_spring(cloth, SpringKind::bend, 0, 4)->width_factor, 0.5 / 4.25, 1e-15);
    EXPECT_NEAR(find_spring(cloth, SpringKind::bend, 3, 4)->width_factor, 0.5 / 4.25, 1e-15);
}

TEST(MeshSprings, BendDoesNotDependOnWhichWayTheFacesShow) {
    auto positions = unit_square();
    positions.push_back({2, 0.5, 0});
    const MeshCloth cloth = cloth_of(mesh_of(positions, {{0, 1, 2, 3}, {1, 2, 4}}));
    EXPECT_NE(find_spring(cloth, SpringKind::bend, 0, 4), nullptr);
    EXPECT_NE(find_spring(cloth, SpringKind::bend, 3, 4), nullptr);
    ASSERT_EQ(cloth.report.findings.size(), 2u);
    EXPECT_EQ(cloth.report.findings[0],
              "1 edge joins faces that show opposite sides: shading breaks there; the first joins "
              "vertices 2 and 3");
}

TEST(MeshSprings, NoBendSpringAcrossAnEdgeOfThreeFaces) {
    const MeshCloth cloth =
        cloth_of(mesh_of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}},
                         {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
    EXPECT_EQ(spring_counts(cloth), (Counts{7, 0, 0}));
    EXPECT_EQ(cloth.report.non_manifold_edges, 1u);
    EXPECT_EQ(cloth.report.border_edges, 6u);
    EXPECT_NEAR(find_spring(cloth, SpringKind::structural, 0, 1)->width_factor, 1.5, 1e-15);
    EXPECT_EQ(cloth.report.findings[0],
              "1 edge is in three or more faces: no bend spring crosses there; the first joins "
              "vertices 1 and 2");
}

TEST(MeshSprings, FaceSeenTwiceIsLeftOut) {
    const MeshCloth cloth =
        cloth_of(mesh_of(unit_square(), {{0, 1, 2, 3}, {3, 2, 1, 0}, {2, 3, 0, 1}}));
    EXPECT_EQ(spring_counts(cloth), (Counts{4, 2, 0}));
    EXPECT_EQ(cloth.report.duplicate_faces, 2u);
    EXPECT_EQ(cloth.surface.triangles.size(), 2u);
    EXPECT_NEAR(std::accumulate(cloth.areas.begin(), cloth.areas.end(), 0.0), 1.0, 1e-15);
    EXPECT_EQ(cloth.report.findings[0],
              "2 faces have the corners of an earlier face: left out; the first is face 2 "
              "(as face 1)");
}

TEST(MeshSprings, TriangleOnThreeCornersOfAQuadIsNoTwin) {
    const MeshCloth cloth = cloth_of(mesh_of(unit_square(), {{0, 1, 2, 3}, {0, 1, 2}}));
    EXPECT_EQ(cloth.report.duplicate_faces, 0u);
    EXPECT_EQ(cloth.surface.faces.size(), 2u);
}

TEST(MeshSprings, FaceWithoutAreaHasSpringsWithoutWidth) {
    const MeshCloth cloth =
        cloth_of(mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 2, 3}, {0, 1, 2}}));
    EXPECT_EQ(cloth.report.degenerate_faces, 1u);
    EXPECT_EQ(cloth.report.findings[0],
              "1 face has no area: springs, but no mass and no air force; the first is face 2");
    EXPECT_EQ(find_spring(cloth, SpringKind::structural, 0, 1)->width_factor, 0.0);
    EXPECT_EQ(cloth.areas[1], 0.0);
    for (const Spring& spring : cloth.springs) EXPECT_TRUE(std::isfinite(spring.width_factor));
}

TEST(MeshSprings, QuadWithoutAreaHasFiniteShearSprings) {
    const MeshCloth cloth =
        cloth_of(mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2, 3}}));
    EXPECT_EQ(cloth.report.degenerate_faces, 1u);
    EXPECT_EQ(find_spring(cloth, SpringKind::shear, 0, 2)->width_factor, 0.0);
}

TEST(MeshSprings, PiecesAreCounted) {
    Mesh mesh = grid_mesh(3, 3, 1, 1);
    const Mesh other = grid_mesh(2, 2, 1, 1);
    for (const Vec3d p : other.positions) mesh.positions.push_back(p + Vec3d{0, 0, 1});
    mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
    mesh.faces.push_back(face_of({9, 11, 12, 10}));
    const MeshReport report = cloth_of(mesh).report;
    EXPECT_EQ(report.pieces, 2u);
    ASSERT_EQ(report.findings.size(), 1u);
    EXPECT_EQ(report.findings[0], "the mesh is in 2 pieces; the second has vertex 10");
}

}  // namespace
}  // namespace weft::testing
