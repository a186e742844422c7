// The files of a saved scene: paths in it, the state beside it, and what happens where one cannot
// be written.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "math/quoting.h"
#include "support/cloth_scenes.h"
#include "support/file_size_limit.h"
#include "support/recording.h"
#include "support/saved_scene.h"
#include "support/scene_errors.h"
#include "weft/scene.h"

namespace weft {
namespace {

namespace fs = std::filesystem;

const std::string cape = WEFT_SOURCE_DIR "/scenes/cape.obj";

/// The value of a key that stands on a line of its own.
std::string written(const fs::path& file, const std::string& key) {
    const std::string text = test::file_text(file);
    const std::size_t from = text.find("\n" + key + " = ");
    if (from == std::string::npos) return {};
    const std::size_t begin = from + key.size() + 4;
    return text.substr(begin, text.find('\n', begin) - begin);
}

SceneDescription scene_of_mesh(const fs::path& mesh) {
    fs::create_directories(mesh.parent_path());
    fs::copy_file(cape, mesh, fs::copy_options::overwrite_existing);
    const std::vector<SceneOverride> of_mesh{{"cloth.mesh", in_quotes(mesh.string())}};
    return parse_scene("version = 1\n[cloth]\n", "a.toml", of_mesh);
}

SceneDescription scene_with_state() {
    SceneDescription scene = test::bare_sheet(3, 2);
    ClothState state;
    for (std::size_t p = 0; p < 6; ++p) {
        state.positions.push_back(test::random_vector(1, p));
        state.velocities.push_back(1e-200 * test::random_vector(2, p));
    }
    scene.start = {.state_path = {}, .state = std::make_shared<ClothState>(state), .time = 0.1};
    return scene;
}

TEST(SavedSceneFiles, MeshesAreNamedFromThere) {
    const test::ScratchDirectory directory;
    const auto mesh_of = [&](const std::string& mesh, const std::string& file) {
        const SceneDescription scene = scene_of_mesh(directory / mesh);
        fs::create_directories((directory / file).parent_path());
        test::expect_same_scene(scene, test::saved_and_loaded(scene, directory / file));
        return written(directory / file, "mesh");
    };
    EXPECT_EQ(mesh_of("cape.obj", "s.toml"), "\"cape.obj\"");
    EXPECT_EQ(mesh_of("meshes/cape.obj", "s.toml"), "\"meshes/cape.obj\"");
    EXPECT_EQ(mesh_of("meshes/cape.obj", "scenes/s.toml"), "\"../meshes/cape.obj\"");
    EXPECT_EQ(mesh_of("cape.obj", "a/b/s.toml"), "\"../../cape.obj\"");
    EXPECT_EQ(mesh_of("cape.obj", "a/b/c/s.toml"), "\"" + (directory / "cape.obj").string() + "\"");
    EXPECT_EQ(mesh_of("ein \"Umhang\"\n\x01 \xc3\xbc.obj", "mit Leer \xe2\x82\xac/s t.toml"),
              "\"../ein \\\"Umhang\\\"\\u000a\\u0001 \xc3\xbc.obj\"");
}

TEST(SavedSceneFiles, FromALinkedDirectoryPathsAreAbsolute) {
    const test::ScratchDirectory directory;
    const SceneDescription scene = scene_of_mesh(directory / "cape.obj");
    fs::create_directories(directory / "far/away");
    fs::create_directory_symlink(directory / "far/away", directory / "link");
    const fs::path file = directory / "link/s.toml";
    test::expect_same_scene(scene, test::saved_and_loaded(scene, file));
    EXPECT_EQ(written(file, "mesh"), "\"" + (directory / "cape.obj").string() + "\"");
    test::expect_same_scene(scene, load_scene((directory / "far/away/s.toml").string()));
}

TEST(SavedSceneFiles, AreFoundByANameInTheCurrentDirectory) {
    const test::ScratchDirectory directory;
    const fs::path before = fs::current_path();
    fs::current_path(directory.path());
    fs::copy_file(cape, "cape.obj");
    const SceneDescription scene =
        parse_scene("version = 1\n[cloth]\nmesh = \"cape.obj\"\n", "a.toml");
    fs::create_directory("sub");
    for (const char* file : {"s.toml", "./s.toml", "sub/s.toml"}) {
        test::expect_same_scene(scene, test::saved_and_loaded(scene, file));
    }
    fs::current_path(before);
    EXPECT_EQ(written(directory / "sub/s.toml", "mesh"), "\"../cape.obj\"");
}

TEST(SavedSceneFiles, AMeshThatBecameAnotherIsRefused) {
    const test::ScratchDirectory directory;
    const SceneDescription scene = scene_of_mesh(directory / "m.obj");
    test::write_text(directory / "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto error = test::error_of([&] { save_scene(scene, directory / "s.toml"); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::file);
    EXPECT_EQ(error->what(), (directory / "m.obj").string() +
                                 ": is no longer the mesh of the scene that is saved");
    EXPECT_EQ(directory.names(), std::set<std::string>{"m.obj"});
}

TEST(SavedSceneFiles, TexturesAreNamesOrPaths) {
    const test::ScratchDirectory directory;
    SceneDescription scene;
    const auto texture_of = [&](const fs::path& path) {
        fs::copy_file(test::small_texture(), path, fs::copy_options::overwrite_existing);
        scene.render.texture = path.string();
        test::expect_same_scene(scene, test::saved_and_loaded(scene, directory / "s.toml"));
        return written(directory / "s.toml", "texture");
    };
    EXPECT_EQ(texture_of(directory / "silk.png"), "\"silk.png\"");
    EXPECT_EQ(texture_of(directory / "flag"), "\"./flag\"");
    scene.render.texture = "stripes";
    save_scene(scene, directory / "s.toml");
    EXPECT_EQ(written(directory / "s.toml", "texture"), "\"stripes\"");
}

TEST(SavedSceneFiles, TheStateStandsBesideTheScene) {
    const test::ScratchDirectory directory;
    const SceneDescription scene = scene_with_state();
    const fs::path file = directory / "later.toml";
    const std::vector<fs::path> files = save_scene(scene, file);
    EXPECT_EQ(files, (std::vector<fs::path>{file, directory / "later.start.npy"}));
    EXPECT_EQ(directory.names(), (std::set<std::string>{"later.toml", "later.start.npy"}));
    EXPECT_EQ(written(file, "state"), "\"later.start.npy\"");
    const SceneDescription read = load_scene(file.string());
    test::expect_same_scene(scene, read);
    EXPECT_EQ(read.start.time, 0.1);
    EXPECT_EQ(read.start.state_path, (directory / "later.start.npy").string());
    // Saved again over itself, and elsewhere with a state of its own.
    test::expect_same_scene(scene, test::saved_and_loaded(read, file));
    fs::create_directory(directory / "sub");
    save_scene(read, directory / "sub/copy.toml");
    fs::remove(directory / "later.start.npy");
    test::expect_same_scene(scene, load_scene((directory / "sub/copy.toml").string()));
}

TEST(SavedSceneFiles, AnExistingFileIsReplacedWhole) {
    const test::ScratchDirectory directory;
    const fs::path file = directory / "s.toml";
    test::write_text(file, std::string(100'000, '#'));
    test::expect_same_scene({}, test::saved_and_loaded({}, file));
    EXPECT_EQ(directory.names(), std::set<std::string>{"s.toml"});
}

TEST(SavedSceneFiles, WhatCannotBeWrittenLeavesNothing) {
    const test::ScratchDirectory directory;
    const auto error = [](const fs::path& file) {
        const auto thrown = test::error_of([&] { save_scene(scene_with_state(), file); });
        EXPECT_TRUE(thrown && thrown->kind() == ErrorKind::file);
        return thrown ? std::string(thrown->what()) : std::string();
    };
    const std::string missing = (directory / "none/s.toml").string();
    EXPECT_EQ(error(missing), missing + ": cannot write: No such file or directory");
    fs::create_directory(directory / "folder.toml");
    const std::string folder = (directory / "folder.toml").string();
    EXPECT_EQ(error(folder), folder + ": cannot write: Is a directory");
    // The state's place is taken: the old scene stays.
    fs::create_directory(directory / "old.start.npy");
    test::write_text(directory / "old.toml", "version = 1\n");
    const std::string state = (directory / "old.start.npy").string();
    EXPECT_EQ(error(directory / "old.toml"), state + ": cannot write: Is a directory");
    EXPECT_EQ(test::file_text(directory / "old.toml"), "version = 1\n");
    const std::set<std::string> names{"folder.toml", "old.start.npy", "old.toml"};
    EXPECT_EQ(directory.names(), names);
}

TEST(SavedSceneFiles, AFullDiskLeavesTheOldFile) {
    const test::ScratchDirectory directory;
    const fs::path file = directory / "s.toml";
    test::write_text(file, "version = 1\n");
    {
        const test::FileSizeLimit limit(500);
        const auto error = test::error_of([&] { save_scene(SceneDescription{}, file); });
        ASSERT_TRUE(error);
        EXPECT_EQ(error->kind(), ErrorKind::file);
        EXPECT_EQ(error->what(), file.string() + ": cannot write: File too large");
    }
    EXPECT_EQ(test::file_text(file), "version = 1\n");
    EXPECT_EQ(directory.names(), std::set<std::string>{"s.toml"});
}

TEST(SavedSceneFiles, ADirectoryWithoutPermissionIsAnError) {
    const std::string file = geteuid() == 0 ? "/proc/s.toml" : "/s.toml";
    const auto error = test::error_of([&] { save_scene({}, file); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::file);
    EXPECT_EQ(error->place().file, file);
}

}  // namespace
}  // namespace weft
