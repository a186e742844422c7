// Mesh files as texts, and a folder to write them into.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/mesh_file.h"
#include "weft/error.h"

namespace weft::testing {

using Corners = std::array<std::uint32_t, 4>;
using Uv = std::array<float, 2>;

inline const std::string square_obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

inline const std::string ply_header =
    "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
    "property float s\nproperty float t\nelement face 2\n"
    "property list uchar int vertex_indices\nend_header\n";
inline const std::string ply_vertices =
    "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n2 0.5 -0.25 0.5 0.75\n";
inline const std::string ascii_ply =
    "ply\nformat ascii 1.0\n" + ply_header + ply_vertices + "4 0 1 2 3\n3 1 4 2\n";

/// The text with its first `from` replaced by `to`.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// Bytes of a number as a binary PLY has it.
template <typename Number>
inline std::string bytes_of(Number number, bool big_endian) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    if (big_endian != (std::endian::native == std::endian::big))
        std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

/// The mesh of ascii_ply in binary, with a property and an element that a cloth has no use for.
inline std::string binary_ply(bool big_endian) {
    std::string text = "ply\nformat binary_" + std::string(big_endian ? "big" : "little") +
                       "_endian 1.0\ncomment made by hand\nelement remark 1\n"
                       "property list ushort double weights\n" +
                       with(ply_header, "property float s", "property uchar red\nproperty float s");
    text += bytes_of<std::uint16_t>(2, big_endian) + bytes_of(0.5, big_endian) +
            bytes_of(1.5, big_endian);
    const float vertices[5][5] = {{0, 0, 0, 0, 0},
                                  {1, 0, 0, 1, 0},
                                  {1, 1, 0, 1, 1},
                                  {0, 1, 0, 0, 1},
                                  {2, 0.5, -0.25, 0.5, 0.75}};
    for (const auto& vertex : vertices)
        for (int k = 0; k < 5; ++k) {
            if (k == 3) text += '\x7f';
            text += bytes_of(vertex[k], big_endian);
        }
    text += '\4';
    for (const std::int32_t index : {0, 1, 2, 3}) text += bytes_of(index, big_endian);
    text += '\3';
    for (const std::int32_t index : {1, 4, 2}) text += bytes_of(index, big_endian);
    return text;
}

class MeshFile : public ::testing::Test {
protected:
    MeshFile() {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  (std::string("weft_mesh_file_") + test->name());
        std::filesystem::create_directories(folder_);
    }
    ~MeshFile() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    Mesh load(const std::string& name, const std::string& bytes) const {
        return load_mesh(write(name, bytes));
    }
    /// What the error says after the folder's name; empty if there is none.
    std::string error(const std::filesystem::path& path) const {
        try {
            load_mesh(path);
        } catch (const Error& failure) {
            EXPECT_EQ(failure.kind(), ErrorKind::file);
            return std::string(failure.what()).substr(folder_.string().size() + 1);
        }
        return {};
    }
    std::string obj_error(const std::string& text) const { return error(write("a.obj", text)); }
    std::string ply_error(const std::string& bytes) const { return error(write("a.ply", bytes)); }

    std::filesystem::path folder_;
};

}  // namespace weft::testing
