// Every file in scenes/invalid is refused with the message that stands in its first line.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "support/scene_errors.h"
#include "weft/error.h"
#include "weft/scene.h"

namespace weft {
namespace {

std::vector<std::filesystem::path> invalid_scenes() {
    std::vector<std::filesystem::path> paths;
    const std::filesystem::path directory = WEFT_SOURCE_DIR "/scenes/invalid";
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        if (entry.path().extension() == ".toml") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

class InvalidScene : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(InvalidScene, IsRefusedWithTheMessageInItsFirstLine) {
    const std::filesystem::path& path = GetParam();
    std::string first_line;
    std::getline(std::ifstream(path), first_line);
    const std::string mark = "# expect: ";
    ASSERT_TRUE(first_line.starts_with(mark));
    const auto error = test::error_of([&] { load_scene(path.string()); });
    ASSERT_TRUE(error) << "no error; expected: " << first_line;
    std::string message = error->what();
    // The message begins with the path as given; the file knows its own name only.
    ASSERT_TRUE(message.starts_with(path.string()));
    message.replace(0, path.string().size(), path.filename().string());
    EXPECT_EQ(message, first_line.substr(mark.size()));
}

INSTANTIATE_TEST_SUITE_P(Scenes, InvalidScene, testing::ValuesIn(invalid_scenes()),
                         [](const auto& scene) {
                             std::string name = scene.param.stem().string();
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(InvalidScenes, AreAtLeastThirty) {
    EXPECT_GE(invalid_scenes().size(), 30U);
}

TEST(InvalidScenes, OfWhichMissingFilesAreOfKindFile) {
    for (const std::filesystem::path& path : invalid_scenes()) {
        const std::string name = path.stem().string();
        const auto error = test::error_of([&] { load_scene(path.string()); });
        ASSERT_TRUE(error) << name;
        const std::set<std::string> about_files{"mesh-missing", "mesh-is-a-directory",
                                                "start-missing", "texture-missing"};
        const bool about_a_file = about_files.contains(name);
        EXPECT_EQ(error->kind(), about_a_file ? ErrorKind::file : ErrorKind::usage) << name;
    }
}

}  // namespace
}  // namespace weft
