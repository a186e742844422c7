// The drawn surface of a mesh: texture co-ordinates, seams, triangles, areas.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "cloth/mesh_examples.h"

namespace weft::testing {
namespace {

using Uv = std::array<float, 2>;

Mesh two_squares() {
    Mesh mesh = mesh_of(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}},
        {{0, 1, 2, 3}, {4, 5, 6, 7}});
    for (const Vec3d p : mesh.positions)
        mesh.uvs.push_back({static_cast<float>(p.x) / 2, static_cast<float>(p.y)});
    return mesh;
}

double total(const std::vector<double>& areas) {
    return std::accumulate(areas.begin(), areas.end(), 0.0);
}

/// Sum of the areas of the triangles that are drawn.
double drawn_area(const MeshCloth& cloth) {
    double area = 0.0;
    for (const auto& triangle : cloth.surface.triangles) {
        const Vec3d a = cloth.rest_positions[cloth.surface.particle(triangle[0])];
        const Vec3d b = cloth.rest_positions[cloth.surface.particle(triangle[1])];
        const Vec3d c = cloth.rest_positions[cloth.surface.particle(triangle[2])];
        area += 0.5 * length(cross(b - a, c - a));
    }
    return area;
}

TEST(MeshSurface, SeamDoublesItsParticles) {
    Mesh mesh = two_squares();
    mesh.uvs[4] = {0.6f, 0.0f};
    mesh.uvs[7] = {0.6f, 1.0f};
    const Surface surface = cloth_of(mesh).surface;
    EXPECT_EQ(surface.particle_count, 6u);
    EXPECT_EQ(surface.vertex_count(), 8u);
    EXPECT_EQ(surface.vertex_particle, (std::vector<std::uint32_t>{0, 1, 1, 2, 2, 3, 4, 5}));
    EXPECT_EQ(surface.faces[0], (std::array<std::uint32_t, 4>{0, 1, 3, 5}));
    EXPECT_EQ(surface.faces[1], (std::array<std::uint32_t, 4>{2, 6, 7, 4}));
    EXPECT_EQ(surface.uvs[1], (Uv{0.5f, 0.0f}));
    EXPECT_EQ(surface.uvs[2], (Uv{0.6f, 0.0f}));
}

TEST(MeshSurface, DoubledVerticesWithTheSameTextureAreNoSeam) {
    const Surface surface = cloth_of(two_squares()).surface;
    EXPECT_TRUE(surface.vertex_particle.empty());
    EXPECT_EQ(surface.vertex_count(), 6u);
    EXPECT_EQ(surface.faces[1], (std::array<std::uint32_t, 4>{1, 4, 5, 2}));
}

TEST(MeshSurface, SeamMayLieInTheTextureIndicesAlone) {
    Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 1}, {0.5, 0.5}};
    mesh.faces[1].uv = {0, 5, 3};  // at vertex 2, not as face 0 has it
    EXPECT_EQ(cloth_of(mesh).surface.vertex_particle, (std::vector<std::uint32_t>{0, 1, 2, 2, 3}));
    mesh.faces[1].uv = {0, 4, 3};  // another number, the same place
    EXPECT_TRUE(cloth_of(mesh).surface.vertex_particle.empty());
}

TEST(MeshSurface, TrianglesEndInNoVertex) {
    const Surface surface = cloth_of(mesh_of(unit_square(), {{0, 1, 2}, {0, 2, 3}})).surface;
    EXPECT_EQ(surface.faces[0], (std::array<std::uint32_t, 4>{0, 1, 2, Surface::no_vertex}));
}

TEST(MeshSurface, TrianglesShowTheSideOfTheirFaces) {
    const MeshCloth cloth = cloth_of(mesh_of(unit_square(), {{3, 2, 1, 0}}));
    for (const auto& t : cloth.surface.triangles) {
        const auto& x = cloth.rest_positions;
        EXPECT_LT(cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]).z, 0.0);
    }
}

TEST(MeshSurface, QuadThatIsNotConvexIsCutInside) {
    // An arrowhead of area 1, its notch at corner 1: the diagonal 0-2 runs outside.
    const MeshCloth cloth =
        cloth_of(mesh_of({{2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}, {0, 0, 0}}, {{0, 1, 2, 3}}));
    EXPECT_NEAR(drawn_area(cloth), 1.0, 1e-15);
    EXPECT_NEAR(total(cloth.areas), 1.0, 1e-15);
    EXPECT_EQ(cloth.surface.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 3}));
}

TEST(MeshSurface, QuadWithThreeCornersInALineHasNoFlatTriangle) {
    const MeshCloth cloth =
        cloth_of(mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}));
    EXPECT_NEAR(total(cloth.areas), 1.0, 1e-15);
    for (const double area : cloth.areas) EXPECT_GT(area, 0.1);
    EXPECT_EQ(cloth.report.degenerate_faces, 0u);
}

TEST(MeshSurface, AreasSumToTheSurface) {
    Mesh mesh = grid_mesh(20, 15, 0.1, 0.1);
    for (Vec3d& p : mesh.positions) p.z = 0.3 * std::sin(3 * p.x) * std::cos(4 * p.y);
    const MeshCloth cloth = cloth_of(mesh);
    EXPECT_NEAR(total(cloth.areas), drawn_area(cloth), 1e-13);
    EXPECT_GT(total(cloth.areas), 1.9 * 1.4);
}

TEST(MeshSurface, WithoutTextureItIsPlanarOverTheLargestExtents) {
    Mesh hanging = grid_mesh(3, 2, 2.0, 1.0);
    hanging.uvs.clear();
    const MeshCloth cloth = cloth_of(hanging);
    EXPECT_EQ(cloth.surface.uvs,
              (std::vector<Uv>{{0, 1}, {0.5, 1}, {1, 1}, {0, 0}, {0.5, 0}, {1, 0}}));
    EXPECT_EQ(cloth.report.findings[0], "no texture co-ordinates: they follow x and y");
}

TEST(MeshSurface, PlanarTextureOfALyingAndOfASideMesh) {
    Mesh mesh = grid_mesh(2, 2, 1.0, 1.0);
    mesh.uvs.clear();
    Mesh lying = mesh, side = mesh;
    for (Vec3d& p : lying.positions) p = {p.x, 0.0, -p.y};  // rows run along +z
    for (Vec3d& p : side.positions) p = {0.0, p.y, p.x};
    const std::vector<Uv> expected{{0, 1}, {1, 1}, {0, 0}, {1, 0}};
    EXPECT_EQ(cloth_of(lying).surface.uvs, expected);
    EXPECT_EQ(cloth_of(lying).report.findings[0], "no texture co-ordinates: they follow x and z");
    EXPECT_EQ(cloth_of(side).surface.uvs, expected);
    EXPECT_EQ(cloth_of(side).report.findings[0], "no texture co-ordinates: they follow z and y");
}

}  // namespace
}  // namespace weft::testing
