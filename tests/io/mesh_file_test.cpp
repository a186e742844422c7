// Mesh files of either kind.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>
#include <utility>

#include "cloth/mesh_cloth.h"
#include "io/mesh_file_examples.h"

namespace weft::testing {
namespace {

TEST_F(MeshFile, FilesThatCannotBeRead) {
    EXPECT_EQ(error(folder_ / "none.obj"), "none.obj: cannot be read: No such file or directory");
    std::filesystem::create_directory(folder_ / "folder.ply");
    EXPECT_EQ(error(folder_ / "folder.ply"), "folder.ply: cannot be read: not a file");
    EXPECT_EQ(error(write("shirt.stl", "solid")),
              "shirt.stl: a mesh file's name must end in .obj or .ply");
    EXPECT_EQ(error(write("shirt", "solid")), "shirt: a mesh file's name must end in .obj or .ply");
}

TEST_F(MeshFile, FileTooLargeIsRefusedUnread) {
    const auto path = write("large.obj", "");
    std::filesystem::resize_file(path, (std::uintmax_t{1} << 31) + 1);  // sparse
    EXPECT_EQ(error(path),
              "large.obj: a mesh file of 2147483649 bytes is too large: at most 2147483648 are "
              "allowed");
}

TEST_F(MeshFile, BrokenFilesEndInAnErrorOrAMesh) {
    std::mt19937 random(5);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    const std::pair<std::string, std::string> seeds[] = {
        {"a.obj", square_obj + "v 2 0.1 1e-3\nf 1/4 2/3 3/2 4/1\nf -4 -1 -3 # end\n"},
        {"a.ply", ascii_ply},
        {"a.ply", binary_ply(false)},
        {"a.ply", binary_ply(true)}};
    std::size_t refused = 0, built = 0;
    for (const auto& [name, seed] : seeds)
        for (int k = 0; k < 400; ++k) {
            std::string bytes = seed;
            for (std::size_t change = 0; change < 1 + below(3); ++change) {
                const std::size_t at = below(bytes.size() - 1);
                if (below(4) == 0) bytes.erase(at, 1 + below(3));
                if (below(4) == 0) bytes.insert(at, bytes.substr(below(at + 1), below(9)));
                bytes[at] = below(2) == 0 ? static_cast<char>(random()) : "09.-\n e/"[below(8)];
            }
            try {
                build_mesh_cloth(load(name, bytes), name);
                ++built;
            } catch (const Error& failure) {
                EXPECT_EQ(failure.kind(), ErrorKind::file);
                ++refused;
            }
        }
    EXPECT_EQ(refused + built, 1600u);
    EXPECT_GT(refused, 500u);
    EXPECT_GT(built, 50u);
}

}  // namespace
}  // namespace weft::testing
