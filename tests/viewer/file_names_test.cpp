#include "viewer/file_names.h"

#include <gtest/gtest.h>

#include <fstream>

#include "weft/scene.h"

namespace weft::viewer {
namespace {

namespace fs = std::filesystem;

class FileNames : public testing::Test {
protected:
    void SetUp() override {
        directory_ = fs::path(testing::TempDir()) /
                     testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::remove_all(directory_);
        fs::create_directories(directory_);
    }
    void TearDown() override { fs::remove_all(directory_); }
    void touch(const std::string& name) const { std::ofstream(directory_ / name) << "x"; }
    fs::path directory_;
};

TEST_F(FileNames, NumbersGoOnWhereFilesStand) {
    EXPECT_EQ(numbered_file(directory_, "weft-flag", "png").filename(), "weft-flag-0001.png");
    touch("weft-flag-0001.png");
    touch("weft-flag-0002.png");
    touch("weft-flag-0004.png");
    EXPECT_EQ(numbered_file(directory_, "weft-flag", "png").filename(), "weft-flag-0003.png");
}

TEST_F(FileNames, AnEditedSceneGetsANameOfItsOwnOnce) {
    EXPECT_EQ(suggested_scene_file("flag"), "./flag-edited.toml");
    EXPECT_EQ(suggested_scene_file("flag-edited"), "./flag-edited.toml");
}

TEST_F(FileNames, ObjectsToWhatNoSceneFileCanBeCalled) {
    EXPECT_EQ(objection_to_scene_file((directory_ / "my.toml").string()), "");
    EXPECT_EQ(objection_to_scene_file("my.toml"), "");
    EXPECT_NE(objection_to_scene_file(""), "");
    EXPECT_NE(objection_to_scene_file((directory_ / "my.txt").string()), "");
    EXPECT_NE(objection_to_scene_file(directory_.string() + "/"), "");
    EXPECT_NE(objection_to_scene_file((directory_ / "none" / "my.toml").string()), "");
    fs::create_directory(directory_ / "folder.toml");
    EXPECT_NE(objection_to_scene_file((directory_ / "folder.toml").string()), "");
}

TEST_F(FileNames, KnowShippedScenesHoweverTheyAreCalled) {
    const fs::path flag = shipped_scenes().front().path;
    EXPECT_TRUE(is_shipped_scene_file(flag));
    EXPECT_TRUE(is_shipped_scene_file(fs::relative(flag)));
    touch("flag.toml");
    EXPECT_FALSE(is_shipped_scene_file(directory_ / "flag.toml"));
    EXPECT_FALSE(is_shipped_scene_file(directory_ / "none.toml"));
}

}  // namespace
}  // namespace weft::viewer
