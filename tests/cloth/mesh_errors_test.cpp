// Meshes that cannot be a cloth, each with its message.
#include <gtest/gtest.h>

#include <limits>

#include "cloth/mesh_examples.h"

namespace weft::testing {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(MeshErrors, NoFaces) {
    EXPECT_EQ(build_error(mesh_of(unit_square(), {})), "shirt.obj: the mesh has no faces");
    EXPECT_EQ(build_error(Mesh{}), "shirt.obj: the mesh has no faces");
}

TEST(MeshErrors, IndexOutOfRange) {
    EXPECT_EQ(build_error(mesh_of(unit_square(), {{0, 1, 2}, {0, 2, 4}})),
              "shirt.obj: face 2 names vertex 5, but there are 4 vertices");
    EXPECT_EQ(build_error(mesh_of({}, {{0, 1, 2}})),
              "shirt.obj: face 1 names vertex 1, but there are 0 vertices");
}

TEST(MeshErrors, TextureIndexOutOfRange) {
    Mesh mesh = mesh_of(unit_square(), {{0, 1, 2, 3}});
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}};
    EXPECT_EQ(build_error(mesh), "shirt.obj: face 1 names texture vertex 4, but there are 3");
}

TEST(MeshErrors, CoordinateNotFinite) {
    Mesh mesh = mesh_of(unit_square(), {{0, 1, 2, 3}});
    mesh.positions[2].y = nan;
    EXPECT_EQ(build_error(mesh),
              "shirt.obj: vertex 3 has a co-ordinate that is not finite: (1, nan, 0)");
    mesh.positions[2].y = -infinity;
    EXPECT_EQ(build_error(mesh),
              "shirt.obj: vertex 3 has a co-ordinate that is not finite: (1, -inf, 0)");
}

TEST(MeshErrors, CoordinateTooLarge) {
    Mesh mesh = mesh_of(unit_square(), {{0, 1, 2, 3}});
    mesh.positions[0].z = 1e200;
    EXPECT_EQ(build_error(mesh),
              "shirt.obj: vertex 1 lies at (0, 0, 1e+200): co-ordinates up to 1000000000 m are "
              "allowed");
}

TEST(MeshErrors, TextureCoordinateNotFinite) {
    Mesh mesh = mesh_of(unit_square(), {{0, 1, 2, 3}});
    mesh.uvs = {{0, 0}, {1, 0}, {std::numeric_limits<float>::infinity(), 1}, {0, 1}};
    EXPECT_EQ(build_error(mesh),
              "shirt.obj: texture vertex 3 has a co-ordinate that is not finite: (inf, 1)");
}

TEST(MeshErrors, FaceWithTwoOrFiveCorners) {
    Mesh mesh = mesh_of(unit_square(), {{0, 1, 2, 3}});
    for (const int corners : {-1, 2, 5}) {
        mesh.faces[0].corners = corners;
        EXPECT_EQ(build_error(mesh), "shirt.obj: face 1 has " + std::to_string(corners) +
                                         " corners: 3 or 4 are allowed");
    }
}

TEST(MeshErrors, CornersInTheSamePlace) {
    auto positions = unit_square();
    positions.push_back(positions[1]);
    EXPECT_EQ(build_error(mesh_of(positions, {{0, 1, 2, 3}, {1, 2, 4}})),
              "shirt.obj: two corners of face 2 are in the same place (vertices 2 and 5)");
}

TEST(MeshErrors, VertexTwiceInAFace) {
    EXPECT_EQ(build_error(mesh_of(unit_square(), {{0, 1, 2, 0}})),
              "shirt.obj: two corners of face 1 are the same vertex 1");
}

TEST(MeshErrors, EverythingInOnePlace) {
    EXPECT_EQ(build_error(mesh_of({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}})),
              "shirt.obj: two corners of face 1 are in the same place (vertices 1 and 2)");
}

TEST(MeshErrors, NumbersAreThoseOfTheFile) {
    auto positions = unit_square();
    positions.push_back(positions[1]);
    Mesh mesh = mesh_of(positions, {{0, 1, 2}, {0, 2, 3}, {1, 2, 4}});
    mesh.first_number = 0;
    mesh.source_faces = {0, 0, 1};  // the first two were cut from one polygon
    EXPECT_EQ(build_error(mesh),
              "shirt.obj: two corners of face 1 are in the same place (vertices 1 and 4)");
}

TEST(MeshErrors, SourceFacesOfAnotherLength) {
    Mesh mesh = mesh_of(unit_square(), {{0, 1, 2}, {0, 2, 3}});
    mesh.source_faces = {0};
    EXPECT_EQ(build_error(mesh), "shirt.obj: source_faces has 1 entries for 2 faces");
}

}  // namespace
}  // namespace weft::testing
