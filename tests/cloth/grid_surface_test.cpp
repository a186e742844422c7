// Places, areas, masses, surface and normals of a grid.
#include <gtest/gtest.h>

#include <numeric>

#include "support/cloth_scenes.h"

namespace weft::test {
namespace {

TEST(GridPosition, RunsRightwardAndDownwardFromTheOrigin) {
    GridDescription grid{{3.0, 2.0}, {4, 3}, Plane::xy, {0.5, 2.0, -1.0}};
    EXPECT_EQ(grid_position(grid, 0, 0), (Vec3d{0.5, 2.0, -1.0}));
    EXPECT_EQ(grid_position(grid, 3, 0), (Vec3d{3.5, 2.0, -1.0}));
    EXPECT_EQ(grid_position(grid, 1, 2), (Vec3d{1.5, 0.0, -1.0}));
    grid.plane = Plane::xz;
    EXPECT_EQ(grid_position(grid, 2, 1), (Vec3d{2.5, 2.0, 0.0}));
}

TEST(GridMass, IsAQuarterAtCornersAndAHalfOnBorders) {
    SceneDescription scene = bare_sheet(4, 3, 3.0, 2.0);  // cells of 1 m2
    scene.material.mass_per_area = 0.8;
    const ClothModel cloth = build_cloth(scene);
    for (const std::size_t corner : {0u, 3u, 8u, 11u}) EXPECT_DOUBLE_EQ(cloth.masses[corner], 0.2);
    for (const std::size_t border : {1u, 2u, 4u, 7u, 9u, 10u})
        EXPECT_DOUBLE_EQ(cloth.masses[border], 0.4);
    for (const std::size_t inner : {5u, 6u}) EXPECT_DOUBLE_EQ(cloth.masses[inner], 0.8);
    EXPECT_NEAR(cloth.total_mass(), 0.8 * 3.0 * 2.0, 1e-14);
}

TEST(GridMass, AddsUpToAreaTimesDensityForAnyShape) {
    for (const auto& [columns, rows] : {std::pair{2, 2}, {2, 9}, {40, 40}, {61, 41}}) {
        const ClothModel cloth = build_cloth(bare_sheet(columns, rows, 1.7, 0.3));
        EXPECT_NEAR(cloth.total_mass(), 0.2 * 1.7 * 0.3, 1e-14);
    }
}

TEST(GridMass, PerParticleIsTheSameEverywhere) {
    SceneDescription scene = bare_sheet(5, 4);
    scene.material.particle_mass = 0.25;
    const ClothModel cloth = build_cloth(scene);
    for (const double mass : cloth.masses) EXPECT_EQ(mass, 0.25);
    EXPECT_EQ(cloth.total_mass(), 5.0);
}

TEST(GridSurface, HasTwoTrianglesACellFacingForward) {
    for (const Plane plane : {Plane::xy, Plane::xz}) {
        SceneDescription scene = bare_sheet(6, 4, 1.5, 0.6);
        scene.cloth.grid.plane = plane;
        const ClothModel cloth = build_cloth(scene);
        const Surface& surface = cloth.surface;
        EXPECT_EQ(surface.triangles.size(), 2u * 5 * 3);
        EXPECT_EQ(surface.faces.size(), 5u * 3);
        EXPECT_EQ(surface.vertex_count(), 24u);
        EXPECT_EQ(surface.particle_count, 24u);
        double area = 0.0;
        for (const auto& [a, b, c] : surface.triangles) {
            const Vec3d n = cross(cloth.rest_position(b) - cloth.rest_position(a),
                                  cloth.rest_position(c) - cloth.rest_position(a));
            EXPECT_GT(plane == Plane::xy ? n.z : n.y, 0.0);
            area += length(n) / 2;
        }
        EXPECT_NEAR(area, 1.5 * 0.6, 1e-14);
    }
}

TEST(GridSurface, HasUvsFromTopLeftToBottomRight) {
    const ClothModel cloth = build_cloth(bare_sheet(5, 3));
    using Uv = std::array<float, 2>;
    EXPECT_EQ(cloth.surface.uvs[0], (Uv{0.0f, 1.0f}));
    EXPECT_EQ(cloth.surface.uvs[4], (Uv{1.0f, 1.0f}));
    EXPECT_EQ(cloth.surface.uvs[10], (Uv{0.0f, 0.0f}));
    EXPECT_EQ(cloth.surface.uvs[7], (Uv{0.5f, 0.5f}));
}

std::vector<Vec3f> normals_of(const ClothModel& cloth, const std::vector<Vec3d>& x) {
    std::vector<Vec3f> normals(cloth.surface.particle_count, Vec3f{9.0f, 9.0f, 9.0f});
    compute_normals(cloth.surface, x, normals);
    return normals;
}

TEST(GridNormals, OfAFlatSheetPointForward) {
    const ClothModel cloth = build_cloth(bare_sheet(5, 4));
    std::vector<Vec3d> x;
    for (std::size_t p = 0; p < cloth.particle_count; ++p) x.push_back(cloth.rest_position(p));
    for (const Vec3f n : normals_of(cloth, x)) EXPECT_EQ(n, (Vec3f{0.0f, 0.0f, 1.0f}));
}

// A quarter cylinder about the y axis: the normals are the radii, to second order in the angle of a
// cell within, to first order at the ends.
TEST(GridNormals, OfACylinderAreItsRadii) {
    constexpr int columns = 41;
    const ClothModel cloth = build_cloth(bare_sheet(columns, 3));
    std::vector<Vec3d> x;
    std::vector<Vec3d> radii;
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        const double angle = 1.5 * cloth.rest_position(p).x;
        radii.push_back({std::sin(angle), 0.0, std::cos(angle)});
        x.push_back(radii.back() + Vec3d{0.0, cloth.rest_position(p).y, 0.0});
    }
    const std::vector<Vec3f> normals = normals_of(cloth, x);
    for (std::size_t p = 0; p < normals.size(); ++p) {
        EXPECT_NEAR(length(normals[p]), 1.0f, 1e-6f);
        const bool end = p % columns == 0 || p % columns == columns - 1;
        EXPECT_LT(length(vec3_cast<double>(normals[p]) - radii[p]), end ? 0.02 : 0.007) << p;
    }
}

// Weighted by area: a particle between a large horizontal and a small vertical triangle.
TEST(GridNormals, AreWeightedByArea) {
    Surface surface;
    surface.particle_count = 5;
    surface.uvs.resize(5);
    surface.triangles = {{0, 1, 2}, {0, 3, 4}};
    const std::vector<Vec3d> x{{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 4}};
    std::vector<Vec3f> normals(5);
    compute_normals(surface, x, normals);
    EXPECT_NEAR(normals[0].z, 0.6f, 1e-6f);  // 3 against 4 times half a square metre
    EXPECT_NEAR(normals[0].x, 0.8f, 1e-6f);
}

TEST(GridNormals, AreZeroWhereTheClothHasNoArea) {
    const ClothModel cloth = build_cloth(bare_sheet(3, 3));
    const std::vector<Vec3d> x(cloth.particle_count, Vec3d{1.0, 2.0, 3.0});
    for (const Vec3f n : normals_of(cloth, x)) EXPECT_EQ(n, Vec3f{});
}

}  // namespace
}  // namespace weft::test
