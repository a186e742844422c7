// What tests of saved scenes share: whether two scenes are the same wherever their files stand.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "io/scene_json.h"
#include "weft/scene.h"

namespace weft::test {

inline bool is_file(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

/// Fails where anything that counts differs; paths may be spelt in another way.
inline void expect_same_scene(SceneDescription a, SceneDescription b) {
    ASSERT_EQ(a.cloth.mesh == nullptr, b.cloth.mesh == nullptr);
    ASSERT_EQ(a.start.state == nullptr, b.start.state == nullptr);
    if (a.cloth.mesh) {
        EXPECT_TRUE(std::filesystem::equivalent(a.cloth.mesh_path, b.cloth.mesh_path));
        EXPECT_EQ(a.cloth.mesh->positions, b.cloth.mesh->positions);
    }
    if (a.start.state) {
        EXPECT_EQ(a.start.state->positions, b.start.state->positions);
        EXPECT_EQ(a.start.state->velocities, b.start.state->velocities);
    }
    if (is_file(a.render.texture)) {
        EXPECT_TRUE(std::filesystem::equivalent(a.render.texture, b.render.texture));
        b.render.texture = a.render.texture;
    }
    b.cloth.mesh_path = a.cloth.mesh_path;
    b.start.state_path = a.start.state_path;
    EXPECT_EQ(scene_to_json(a), scene_to_json(b));
}

/// Saves the scene as `file` and reads it back.
inline SceneDescription saved_and_loaded(const SceneDescription& scene,
                                         const std::filesystem::path& file) {
    save_scene(scene, file);
    return load_scene(file.string());
}

}  // namespace weft::test
