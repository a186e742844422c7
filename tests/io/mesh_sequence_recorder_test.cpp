// Folders of OBJ and PLY files.
#include <gtest/gtest.h>

#include <sstream>

#include "support/recording.h"

namespace weft {
namespace {

using test::file_text;
using test::little_at;
using test::record;
using test::ScratchDirectory;

TEST(ObjSequenceRecorder, WritesOneMeshForEachFrame) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 2);
    const auto files = record("obj", cloth, scratch.path(), 9, 3);
    EXPECT_EQ(files, (std::vector{scratch / "wave.obj-frames/wave.0000.obj",
                                  scratch / "wave.obj-frames/wave.0001.obj",
                                  scratch / "wave.obj-frames/wave.0002.obj"}));
    for (std::size_t i = 0; i < 3; ++i) {
        const Frame frame = cloth.frame(i);
        std::istringstream lines(file_text(files[i]));
        std::vector<std::string> v, vt, vn, f;
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("v ")) v.push_back(line);
            if (line.starts_with("vt ")) vt.push_back(line);
            if (line.starts_with("vn ")) vn.push_back(line);
            if (line.starts_with("f ")) f.push_back(line);
        }
        ASSERT_EQ(v.size(), 6U);
        ASSERT_EQ(vn.size(), 6U);
        for (std::size_t p = 0; p < 6; ++p) {
            float x = 0, y = 0, z = 0;
            ASSERT_EQ(std::sscanf(v[p].c_str(), "v %f %f %f", &x, &y, &z), 3);
            EXPECT_EQ((Vec3f{x, y, z}), vec3_cast<float>(frame.positions[p]));
            ASSERT_EQ(std::sscanf(vn[p].c_str(), "vn %f %f %f", &x, &y, &z), 3);
            EXPECT_EQ((Vec3f{x, y, z}), frame.normals[p]);
        }
        EXPECT_EQ(vt.front(), "vt 0 1");
        EXPECT_EQ(f, (std::vector<std::string>{"f 1/1/1 4/4/4 5/5/5 2/2/2",
                                               "f 2/2/2 5/5/5 6/6/6 3/3/3"}));
    }
}

TEST(PlySequenceRecorder, WritesVerticesAndFacesExactly) {
    ScratchDirectory scratch;
    auto cloth = test::waving_sleeve(5, 3);
    const auto files = record("ply", cloth, scratch.path(), 3, 3);
    ASSERT_EQ(files.size(), 3U);
    EXPECT_EQ(files[2], scratch / "wave.ply-frames/wave.0002.ply");
    const Surface& surface = cloth.surface;
    const Frame frame = cloth.frame(2);
    const std::string bytes = file_text(files[2]);
    const std::string last_line = "end_header\n";
    const std::size_t begin = bytes.find(last_line) + last_line.size();
    const std::string head = bytes.substr(0, begin);
    EXPECT_TRUE(head.starts_with("ply\nformat binary_little_endian 1.0\n"));
    EXPECT_NE(head.find("element vertex 18\n"), std::string::npos);
    EXPECT_NE(head.find("element face 15\n"), std::string::npos);
    // 18 vertices of 8 floats, 10 triangles of 13 bytes, 5 quads of 17 bytes.
    ASSERT_EQ(bytes.size(), begin + 18U * 32U + 10U * 13U + 5U * 17U);
    std::size_t at = begin;
    for (std::uint32_t vertex = 0; vertex < 18; ++vertex) {
        const std::uint32_t p = surface.particle(vertex);
        const auto q = vec3_cast<float>(frame.positions[p]);
        const Vec3f n = frame.normals[p];
        for (const float value :
             {q.x, q.y, q.z, n.x, n.y, n.z, surface.uvs[vertex][0], surface.uvs[vertex][1]}) {
            EXPECT_EQ(little_at<float>(bytes, at), value);
            at += 4;
        }
    }
    for (const auto& face : surface.faces) {
        const int corners = face[3] == Surface::no_vertex ? 3 : 4;
        EXPECT_EQ(little_at<std::uint8_t>(bytes, at++), corners);
        for (std::size_t k = 0; k < static_cast<std::size_t>(corners); ++k, at += 4)
            EXPECT_EQ(little_at<std::uint32_t>(bytes, at), face[k]);
    }
}

TEST(MeshSequence, ReplacesTheFolderOfAnEarlierLongerRun) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 2);
    for (const char* format : {"obj", "ply"}) {
        record(format, cloth, scratch.path(), 5, 5);
        record(format, cloth, scratch.path(), 2, 2);
        const auto folder = scratch / ("wave." + std::string(format) + "-frames");
        EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
    }
    EXPECT_EQ(scratch.names(), (std::set<std::string>{"wave.obj-frames", "wave.ply-frames"}));
}

}  // namespace
}  // namespace weft
