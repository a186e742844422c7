// Meshes from OBJ files, and the lines that are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cloth/mesh_cloth.h"
#include "io/mesh_file_examples.h"

namespace weft::testing {
namespace {

TEST_F(MeshFile, ObjKeepsQuadsAndTheOrderOfItsVertices) {
    const Mesh mesh =
        load("a.obj", square_obj + "v 2 0.1 1e-3\nf 1/4 2/3 3/2 4/1\nf 2/2 5/3 3/4\n");
    ASSERT_EQ(mesh.positions.size(), 5u);
    EXPECT_EQ(mesh.positions[4], (Vec3d{2, 0.1, 1e-3}));  // in double precision
    ASSERT_EQ(mesh.faces.size(), 2u);
    EXPECT_EQ(mesh.faces[0].corners, 4);
    EXPECT_EQ(mesh.faces[0].position, (Corners{0, 1, 2, 3}));
    EXPECT_EQ(mesh.faces[0].uv, (Corners{3, 2, 1, 0}));
    EXPECT_EQ(mesh.faces[1].corners, 3);
    EXPECT_EQ(mesh.faces[1].position, (Corners{1, 4, 2, 0}));
    EXPECT_EQ(mesh.uvs[3], (Uv{0, 1}));
    EXPECT_EQ(mesh.first_number, 1);
    EXPECT_TRUE(mesh.source_faces.empty());
}

TEST_F(MeshFile, ObjFacesMayHaveNormalsGroupsCommentsAndContinuedLines) {
    const Mesh mesh = load("a.obj", "# comment\r\nmtllib none.mtl\r\no thing\r\n" + square_obj +
                                        "vn 0 0 1\ng a b\nusemtl red\ns off\n"
                                        "f 1/1/1 2/2/1 \\\n 3/3/1 # corner\n\n  f 1/1 3/3 4/4");
    ASSERT_EQ(mesh.faces.size(), 2u);
    EXPECT_EQ(mesh.faces[0].position, (Corners{0, 1, 2, 0}));
    EXPECT_EQ(mesh.faces[1].position, (Corners{0, 2, 3, 0}));
    EXPECT_EQ(mesh.uvs.size(), 4u);
}

TEST_F(MeshFile, ObjNegativeIndicesCountBack) {
    const Mesh mesh = load("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
    EXPECT_EQ(mesh.faces[0].position, (Corners{0, 1, 2, 0}));
    EXPECT_EQ(mesh.faces[1].position, (Corners{0, 2, 3, 0}));
}

TEST_F(MeshFile, ObjFaceOfManyCornersIsAFanFromItsFirst) {
    const Mesh mesh =
        load("a.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3\nf 1 2 3 4 5\n");
    ASSERT_EQ(mesh.faces.size(), 4u);
    EXPECT_EQ(mesh.faces[1].position, (Corners{0, 1, 2, 0}));
    EXPECT_EQ(mesh.faces[2].position, (Corners{0, 2, 3, 0}));
    EXPECT_EQ(mesh.faces[3].position, (Corners{0, 3, 4, 0}));
    EXPECT_EQ(mesh.source_faces, (std::vector<std::uint32_t>{0, 1, 1, 1}));
    const MeshReport report = build_mesh_cloth(mesh, "a.obj").report;
    EXPECT_EQ(report.findings[0],
              "1 face has more than four corners: cut into triangles, no shear springs; the first "
              "is face 2");
}

TEST_F(MeshFile, ObjFaceOfThreeHundredCornersIsWhole) {
    std::string text, face = "f";
    for (int k = 0; k < 300; ++k) {
        text += "v " + std::to_string(std::cos(k * 0.02)) + " " +
                std::to_string(std::sin(k * 0.02)) + " 0\n";
        face += " " + std::to_string(k + 1);
    }
    const Mesh mesh = load("a.obj", text + face + "\n");
    ASSERT_EQ(mesh.faces.size(), 298u);
    EXPECT_EQ(mesh.faces.back().position, (Corners{0, 298, 299, 0}));
}

TEST_F(MeshFile, ObjWithSomeCornersWithoutTextureHasNone) {
    EXPECT_TRUE(load("a.obj", square_obj + "f 1/1 2/2 3/3\nf 1 3 4\n").uvs.empty());
    EXPECT_TRUE(load("a.obj", square_obj + "f 1 2 3 4\n").uvs.empty());
}

TEST_F(MeshFile, EndingMayBeInCapitals) {
    EXPECT_EQ(load("a.OBJ", square_obj + "f 1 2 3 4\n").faces.size(), 1u);
    EXPECT_EQ(load("a.Ply", ascii_ply).faces.size(), 2u);
}

TEST_F(MeshFile, ObjLinesThatAreRefused) {
    EXPECT_EQ(obj_error("v 0 0 zero\n"), "a.obj:1: zero is not a number");
    EXPECT_EQ(obj_error("v 0 0 0\nv 0 nan 0\n"), "a.obj:2: nan is not a finite number");
    EXPECT_EQ(obj_error("v 0 -inf 0\n"), "a.obj:1: -inf is not a finite number");
    EXPECT_EQ(obj_error("v 1e999 0 0\n"), "a.obj:1: 1e999 is not a finite number");
    EXPECT_EQ(obj_error("v 0 0\n"), "a.obj:1: 2 numbers stand here: at least 3 are needed");
    EXPECT_EQ(obj_error("\n\nvt\n"), "a.obj:3: 0 numbers stand here: at least 1 are needed");
    EXPECT_EQ(obj_error(square_obj + "f 1 2\n"),
              "a.obj:9: the face has 2 corners: at least 3 are needed");
    EXPECT_EQ(obj_error(square_obj + "f 1 2 \\\n\\\n3\nv 1 2 x\n"), "a.obj:12: x is not a number");
    EXPECT_EQ(obj_error("v \x1b[31m 0 0\n"), "a.obj:1: ?[31m is not a number");
    EXPECT_EQ(obj_error("v " + std::string(100, '7') + "x 0 0\n"),
              "a.obj:1: " + std::string(40, '7') + "... is not a number");
}

TEST_F(MeshFile, ObjCornersThatAreRefused) {
    for (const std::string corner : {"0", "1/", "1//", "1/1/", "1/0", "1/1/1/1", "a", "1x", "1.5",
                                     "/1", "99999999999", "1/99999999999", "-"})
        EXPECT_EQ(obj_error(square_obj + "f 1 2 " + corner + "\n"),
                  "a.obj:9: " + corner +
                      " is not a face corner: v, v/vt, v//vn or v/vt/vn with whole numbers other "
                      "than 0 are allowed");
}

TEST_F(MeshFile, ObjIndicesOutOfRange) {
    EXPECT_EQ(obj_error(square_obj + "f 1 2 3\nf 1 2 5\n"),
              "a.obj: face 2 names vertex 5, but there are 4 vertices");
    EXPECT_EQ(obj_error(square_obj + "f 1 2 -5\n"),
              "a.obj: face 1 names vertex -5, but 4 stand before it");
    EXPECT_EQ(obj_error(square_obj + "f 1/1 2/2 3/-5\n"),
              "a.obj: face 1 names texture vertex -5, but 4 stand before it");
    EXPECT_EQ(obj_error(square_obj + "f 1/1 2/2 3/9\n"),
              "a.obj: face 1 names texture vertex 9, but there are 4");
    EXPECT_EQ(obj_error(square_obj + "f 1 2 2147483647\n"),
              "a.obj: face 1 names vertex 2147483647, but there are 4 vertices");
    EXPECT_EQ(obj_error(square_obj + "f 1 2 -2147483648\n"),
              "a.obj: face 1 names vertex -2147483648, but 4 stand before it");
}

TEST_F(MeshFile, ObjWithoutFaces) {
    EXPECT_EQ(obj_error(""), "a.obj: the mesh has no faces");
    EXPECT_EQ(obj_error(square_obj), "a.obj: the mesh has no faces");
    EXPECT_EQ(obj_error(std::string("v 0 0 0\n\0f", 10)),
              "a.obj: not an OBJ file: it holds zero bytes");
}

}  // namespace
}  // namespace weft::testing
