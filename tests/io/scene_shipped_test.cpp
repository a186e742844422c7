// The scenes that ship, and where they are found.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/data_directory.h"
#include "io/scene_json.h"
#include "support/recording.h"
#include "support/scene_errors.h"
#include "weft/scene.h"

namespace weft {
namespace {

/// Sets WEFT_DATA_DIR while it lives.
class DataDirectory {
public:
    explicit DataDirectory(const std::string& directory) {
        setenv("WEFT_DATA_DIR", directory.c_str(), 1);
    }
    ~DataDirectory() { unsetenv("WEFT_DATA_DIR"); }
    DataDirectory(const DataDirectory&) = delete;
    DataDirectory& operator=(const DataDirectory&) = delete;
};

TEST(ShippedScenes, AreTheSixSortedByName) {
    std::vector<std::string> names;
    for (const ShippedScene& scene : shipped_scenes()) {
        names.push_back(scene.name);
        EXPECT_FALSE(scene.title.empty());
        EXPECT_EQ(scene.title, load_scene(scene.name).name);
    }
    const std::vector<std::string> expected{"banner", "curtain",   "drape",
                                            "flag",   "mesh-cape", "sheet"};
    EXPECT_EQ(names, expected);
}

TEST(ShippedScenes, BeginWithACommentSayingWhatTheyShow) {
    for (const ShippedScene& scene : shipped_scenes()) {
        std::string line;
        std::getline(std::ifstream(scene.path), line);
        EXPECT_TRUE(line.starts_with("# ")) << scene.path;
    }
}

TEST(ShippedScenes, FlagIsTheDefaultDescription) {
    const SceneDescription flag = load_scene("flag");
    EXPECT_EQ(scene_to_json(flag).dump(), scene_to_json(SceneDescription{}).dump());
    EXPECT_EQ(flag.stem, "flag");
    EXPECT_EQ(std::filesystem::path(flag.file).filename(), "flag.toml");
}

TEST(ShippedScenes, SheetIsThatOfTheComparisonOfMethods) {
    const SceneDescription sheet = load_scene("sheet");
    EXPECT_EQ(sheet.cloth.grid.resolution, (std::array{40, 40}));
    EXPECT_EQ(sheet.cloth.grid.size, (std::array{20.0, 20.0}));
    EXPECT_EQ(sheet.material.stiffness_per, StiffnessPer::spring);
    EXPECT_EQ(sheet.material.particle_mass, 1.0);
    for (const SpringMaterial& spring :
         {sheet.material.structural, sheet.material.shear, sheet.material.bend}) {
        EXPECT_EQ(spring.stiffness, 800.0);
        EXPECT_EQ(spring.damping, 0.0);
    }
    EXPECT_EQ(sheet.forces.damping, 0.0);
    EXPECT_FALSE(sheet.wind);
    ASSERT_EQ(sheet.pins.size(), 2U);
    EXPECT_EQ(std::get<EdgeSelection>(sheet.pins[0].select), EdgeSelection::top_left);
    EXPECT_EQ(std::get<EdgeSelection>(sheet.pins[1].select), EdgeSelection::top_right);
    EXPECT_EQ(sheet.integrator.time_step, 0.001);
    EXPECT_DOUBLE_EQ(1.0 / sheet.output.frames_per_second, 20 * 0.001);
    EXPECT_EQ(sheet.frame_count(), 250U);
}

TEST(ShippedScenes, CapeBringsItsMesh) {
    const SceneDescription cape = load_scene("mesh-cape");
    ASSERT_NE(cape.cloth.mesh, nullptr);
    EXPECT_GT(cape.cloth.mesh->positions.size(), 1000U);
    EXPECT_EQ(std::filesystem::path(cape.cloth.mesh_path).filename(), "cape.obj");
}

TEST(ShippedScenes, AreFoundInTheDirectoryOfTheEnvironment) {
    const test::ScratchDirectory directory;
    std::filesystem::create_directory(directory / "scenes");
    test::write_text(directory / "scenes/towel.toml", "version = 1\nname = \"Towel\"\n[cloth]\n");
    const DataDirectory chosen(directory.path().string());
    EXPECT_EQ(data_directory(), directory.path());
    ASSERT_EQ(shipped_scenes().size(), 1U);
    EXPECT_EQ(shipped_scenes()[0].title, "Towel");
    EXPECT_EQ(load_scene("towel").stem, "towel");
}

TEST(ShippedScenes, ADirectoryOfTheEnvironmentWithoutScenesIsAnError) {
    const test::ScratchDirectory directory;
    const DataDirectory chosen(directory.path().string());
    const auto error = test::error_of([] { load_scene("flag"); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::file);
    EXPECT_EQ(error->what(), directory.path().string() + ": holds no directory \"scenes\"");
}

TEST(ShippedScenes, AnUnknownNameGetsTheNearestAndTheList) {
    const auto error = test::error_of([] { load_scene("flga"); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::usage);
    EXPECT_STREQ(error->what(),
                 "no shipped scene is called \"flga\" (did you mean flag?); there are banner, "
                 "curtain, drape, flag, mesh-cape, sheet");
}

}  // namespace
}  // namespace weft
