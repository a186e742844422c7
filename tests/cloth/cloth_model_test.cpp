// The cloth that a scene becomes: names, masses, grids and meshes alike.
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "weft/error.h"

namespace weft::test {
namespace {

TEST(ClothModel, NamesParticlesByColumnAndRowOnAGridOnly) {
    SceneDescription scene = bare_sheet(5, 4);
    EXPECT_EQ(build_cloth(scene).particle_name(13), "13 (column 3, row 2)");
    make_mesh_of_grid(scene);
    EXPECT_EQ(build_cloth(scene).particle_name(13), "13");
}

// A grid and the same grid as a mesh of quads have the same particles and structural and shear
// springs; a mesh's bend springs join what lies across an edge, so only structural and shear
// compare.
TEST(ClothModel, OfAMeshOfQuadsHasTheGridsSpringsAndMass) {
    SceneDescription scene = bare_sheet(6, 5, 1.2, 0.9);
    const ClothModel grid = build_cloth(scene);
    make_mesh_of_grid(scene);
    const ClothModel mesh = build_cloth(scene);
    EXPECT_TRUE(grid.is_grid());
    EXPECT_FALSE(mesh.is_grid());
    EXPECT_EQ(mesh.particle_count, grid.particle_count);
    EXPECT_EQ(mesh.spring_counts()[0], grid.spring_counts()[0]);
    EXPECT_EQ(mesh.spring_counts()[1], grid.spring_counts()[1]);
    EXPECT_NEAR(mesh.total_mass(), grid.total_mass(), 1e-14);
    for (std::size_t p = 0; p < grid.particle_count; ++p) {
        EXPECT_EQ(mesh.rest_position(p), grid.rest_position(p));
    }
}

// A third of each triangle around: on a unit square cut once, two corners have 1/3, two 1/6.
TEST(ClothModel, OfAMeshSharesEachTriangleInThirds) {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const auto& corners : {std::array<std::uint32_t, 4>{0, 1, 2, 0}, {0, 2, 3, 0}}) {
        Mesh::Face face;
        face.position = corners;
        mesh->faces.push_back(face);
    }
    SceneDescription scene = bare_sheet(2, 2);
    scene.cloth.mesh = mesh;
    scene.cloth.mesh_path = "square.obj";
    scene.material.mass_per_area = 0.6;
    const ClothModel cloth = build_cloth(scene);
    const std::array<double, 4> expected{0.2, 0.1, 0.2, 0.1};
    for (std::size_t p = 0; p < 4; ++p) EXPECT_NEAR(cloth.masses[p], expected[p], 1e-15);
}

TEST(ClothModel, ChoosesParticleMassOverMassPerArea) {
    SceneDescription scene = bare_sheet(3, 3);
    scene.material.mass_per_area = 100.0;
    scene.material.particle_mass = 0.5;
    make_mesh_of_grid(scene);
    EXPECT_EQ(build_cloth(scene).total_mass(), 4.5);
}

TEST(ClothModel, KeepsPlainStiffnessOnAMeshPerSpring) {
    SceneDescription scene = bare_sheet(4, 4, 1.0, 0.5);
    make_mesh_of_grid(scene);
    build_cloth(scene).for_each_spring([&](const Spring& spring, const SpringConstants& constants) {
        const std::array<double, 3> plain{100.0, 40.0, 5.0};
        EXPECT_EQ(constants.stiffness, plain[static_cast<std::size_t>(spring.kind)]);
        EXPECT_EQ(spring.width_factor, 1.0);
    });
}

}  // namespace
}  // namespace weft::test
