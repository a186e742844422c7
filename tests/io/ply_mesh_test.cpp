// Meshes from PLY files, and the headers and bodies that are refused.
#include <gtest/gtest.h>

#include <string>

#include "io/mesh_file_examples.h"

namespace weft::testing {
namespace {

void expect_ply_mesh(const Mesh& mesh) {
    ASSERT_EQ(mesh.positions.size(), 5u);
    EXPECT_EQ(mesh.positions[1], (Vec3d{1, 0, 0}));
    EXPECT_EQ(mesh.positions[4], (Vec3d{2, 0.5, -0.25}));
    ASSERT_EQ(mesh.uvs.size(), 5u);
    EXPECT_EQ(mesh.uvs[4], (Uv{0.5f, 0.75f}));
    ASSERT_EQ(mesh.faces.size(), 2u);
    EXPECT_EQ(mesh.faces[0].corners, 4);
    EXPECT_EQ(mesh.faces[0].position, (Corners{0, 1, 2, 3}));
    EXPECT_EQ(mesh.faces[1].corners, 3);
    EXPECT_EQ(mesh.faces[1].position, (Corners{1, 4, 2, 0}));
    EXPECT_EQ(mesh.faces[1].uv, (Corners{1, 4, 2, 0}));
    EXPECT_EQ(mesh.first_number, 0);
}

TEST_F(MeshFile, PlyInAsciiAndBothBinaryForms) {
    expect_ply_mesh(load("a.ply", ascii_ply));
    expect_ply_mesh(load("a.ply", binary_ply(false)));
    expect_ply_mesh(load("a.ply", binary_ply(true)));
}

TEST_F(MeshFile, PlyMayHaveOtherLineEndsNamesOrdersAndElements) {
    std::string windows;
    for (const char c : ascii_ply) windows += c == '\n' ? "\r\n" : std::string(1, c);
    expect_ply_mesh(load("a.ply", windows));
    expect_ply_mesh(load("a.ply", with(with(ascii_ply, "float s", "float32 texture_u"), "float t",
                                       "double texture_v")));
    const std::string faces = "element face 2\nproperty list uint8 uint32 vertex_index\n";
    expect_ply_mesh(load("a.ply", "ply\nformat ascii 1.0\nobj_info x\n" + faces +
                                      with(with(ply_header, faces.substr(0, 15), "comment c\n"),
                                           "property list uchar int vertex_indices\n",
                                           "element edge 1\nproperty list uchar float weights\n") +
                                      "4 0 1 2 3\n\n3 1 4 2\n" + ply_vertices + "2 7 8\n"));
}

TEST_F(MeshFile, PlyWithoutTexture) {
    const Mesh mesh =
        load("a.ply", with(with(ascii_ply, "float s", "float q"), "float t", "float confidence"));
    EXPECT_EQ(mesh.positions.size(), 5u);
    EXPECT_TRUE(mesh.uvs.empty());
}

TEST_F(MeshFile, PlyFaceOfManyCornersIsAFan) {
    const Mesh mesh = load("a.ply", with(ascii_ply, "4 0 1 2 3", "5 0 1 4 2 3"));
    ASSERT_EQ(mesh.faces.size(), 4u);
    EXPECT_EQ(mesh.faces[2].position, (Corners{0, 2, 3, 0}));
    EXPECT_EQ(mesh.source_faces, (std::vector<std::uint32_t>{0, 0, 0, 1}));
}

TEST_F(MeshFile, PlyHeadersThatAreRefused) {
    EXPECT_EQ(ply_error(""), "a.ply: not a PLY file: the first line must be \"ply\"");
    EXPECT_EQ(ply_error("plywood\n"), "a.ply: not a PLY file: the first line must be \"ply\"");
    EXPECT_EQ(ply_error("ply\nformat ascii 1.0\n"), "a.ply: the header has no end_header line");
    EXPECT_EQ(ply_error(with(ascii_ply, "ascii", "utf8")),
              "a.ply:2: the second line must be \"format\" with one of ascii, "
              "binary_little_endian, binary_big_endian and 1.0");
    EXPECT_EQ(ply_error(with(ascii_ply, "vertex 5", "vertex -5")),
              "a.ply:3: an element has a name and a count");
    EXPECT_EQ(ply_error(with(ascii_ply, "float x", "half x")),
              "a.ply:4: half is not a type of PLY");
    EXPECT_EQ(ply_error(with(ascii_ply, "property float x", "property x")),
              "a.ply:4: a property has a type and a name");
    EXPECT_EQ(ply_error(with(ascii_ply, "list uchar", "list float")),
              "a.ply:10: the count of a list is a whole number");
    EXPECT_EQ(ply_error(with(ascii_ply, "property float x", "propperty float x")),
              "a.ply:4: propperty is not known in a PLY header");
    EXPECT_EQ(ply_error(with(ascii_ply, "element vertex 5\n", "")),
              "a.ply:3: a property stands before the first element");
}

TEST_F(MeshFile, PlyElementsThatAreRefused) {
    EXPECT_EQ(ply_error(with(ascii_ply, "element face", "element vertex")),
              "a.ply:9: the element vertex stands here twice");
    EXPECT_EQ(ply_error(with(ascii_ply, "float s", "float y")),
              "a.ply: element vertex has two properties for y");
    EXPECT_EQ(ply_error(with(ascii_ply, "float z", "float w")),
              "a.ply: element vertex has no property z");
    EXPECT_EQ(ply_error(with(ascii_ply, "vertex_indices", "corners")),
              "a.ply: element face has no property vertex_indices");
    EXPECT_EQ(ply_error(with(ascii_ply, "int vertex_indices", "float vertex_indices")),
              "a.ply: vertex_indices must be whole numbers");
    EXPECT_EQ(ply_error(with(ascii_ply, "element face", "element faces")),
              "a.ply: the mesh has no faces");
    EXPECT_EQ(ply_error(with(ascii_ply, "element face 2", "element face 0")),
              "a.ply: the mesh has no faces");
    EXPECT_EQ(ply_error(with(ascii_ply, "vertex 5", "vertex 0")),
              "a.ply: the mesh has no vertices");
}

TEST_F(MeshFile, PlyCountsBeyondTheFileAreRefusedAtOnce) {
    const auto size = [](const std::string& bytes) { return std::to_string(bytes.size()); };
    for (const std::string count : {"1000000000000", "18446744073709551615"}) {
        std::string huge = with(ascii_ply, "vertex 5", "vertex " + count);
        EXPECT_EQ(ply_error(huge), "a.ply: " + count +
                                       " elements vertex do not fit in the file's " + size(huge) +
                                       " bytes");
        huge = with(binary_ply(false), "face 2", "face " + count);
        EXPECT_EQ(ply_error(huge), "a.ply: " + count + " elements face do not fit in the file's " +
                                       size(huge) + " bytes");
    }
    EXPECT_EQ(ply_error(with(ascii_ply, "vertex 5", "vertex 18446744073709551616")),
              "a.ply:3: an element has a name and a count");
}

TEST_F(MeshFile, PlyListsBeyondTheFileAreRefusedAtOnce) {
    EXPECT_EQ(ply_error(with(ascii_ply, "4 0 1 2 3", "4000000000 0 1 2 3")),
              "a.ply:17: face 0: the line holds fewer numbers than the header says");
    const std::string wide = with(binary_ply(true), "list uchar int", "list uint int");
    EXPECT_EQ(ply_error(wide), "a.ply: face 0: the file ends here: the header says that 2 follow");
    std::string negative = with(binary_ply(false), "list uchar int", "list char int");
    negative[negative.size() - 13] = '\xff';
    EXPECT_EQ(ply_error(negative), "a.ply: face 1: a list has a negative count");
}

TEST_F(MeshFile, PlyBodiesThatAreRefused) {
    EXPECT_EQ(ply_error(with(ascii_ply, "1 1 0 1 1", "1 1 zero 1 1")),
              "a.ply:14: vertex 2: zero is not a number of type float");
    EXPECT_EQ(ply_error(with(ascii_ply, "1 1 0 1 1", "1 1 0")),
              "a.ply:14: vertex 2: the line holds fewer numbers than the header says");
    EXPECT_EQ(ply_error(with(ascii_ply, "1 1 0 1 1", "1 1 0 1 1 1")),
              "a.ply:14: vertex 2: the line holds more numbers than the header says");
    EXPECT_EQ(ply_error(with(ascii_ply, "4 0 1 2 3", "4 0 1 2.5 3")),
              "a.ply:17: face 0: 2.5 is not a number of type int");
    EXPECT_EQ(ply_error(with(ascii_ply, "4 0 1 2 3", "x 0 1 2 3")),
              "a.ply:17: face 0: x is not the count of a list");
    EXPECT_EQ(ply_error(with(ascii_ply, "4 0 1 2 3", "4 0 1 2 4294967296")),
              "a.ply:17: face 0: 4294967296 is out of range");
    EXPECT_EQ(ply_error(with(ascii_ply, "3 1 4 2\n", "")),
              "a.ply: face 1: the file ends here: the header says that 2 follow");
    EXPECT_EQ(ply_error(with(ascii_ply, "3 1 4 2\n", "2 1 4\n")),
              "a.ply: face 1 has 2 corners: at least 3 are needed");
}

TEST_F(MeshFile, PlyIndicesAndCoordinatesThatAreRefused) {
    EXPECT_EQ(ply_error(with(ascii_ply, "3 1 4 2", "3 1 4 5")),
              "a.ply: face 1 names vertex 5, but there are 5 vertices");
    EXPECT_EQ(ply_error(with(ascii_ply, "3 1 4 2", "3 1 4 -1")),
              "a.ply: face 1 names vertex 4294967295, but there are 5 vertices");
    EXPECT_EQ(ply_error(with(ascii_ply, "1 1 0 1 1", "1 nan 0 1 1")),
              "a.ply: vertex 2 has a co-ordinate that is not finite: (1, nan, 0)");
    EXPECT_EQ(ply_error(with(ascii_ply, "1 1 0 1 1", "inf 1 0 1 1")),
              "a.ply: vertex 2 has a co-ordinate that is not finite: (inf, 1, 0)");
    EXPECT_EQ(ply_error(with(ascii_ply, "1 1 0 1 1", "1 1 0 nan 1")),
              "a.ply: texture vertex 2 has a co-ordinate that is not finite: (nan, 1)");
}

TEST_F(MeshFile, PlyCutShortAnywhereIsRefused) {
    for (const std::string& whole : {binary_ply(false), binary_ply(true)})
        for (std::size_t size = 0; size < whole.size(); ++size)
            EXPECT_NE(ply_error(whole.substr(0, size)), "") << size;
}

}  // namespace
}  // namespace weft::testing
