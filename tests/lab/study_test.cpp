// A study is refused where its runs would not be those of the scene.
#include "lab/study.h"

#include <gtest/gtest.h>

#include "support/scene_errors.h"

namespace weft::lab {
namespace {

std::string refused_key(const SceneDescription& scene) {
    StudyPlan plan;
    plan.scenes = {SceneDescription{}, scene};
    const auto error = test::error_of([&] { run_study(plan); });
    return error && error->kind() == ErrorKind::usage ? error->place().key : "";
}

TEST(Study, IsNoneAmongObstaclesOrFromAnotherStart) {
    SceneDescription scene;
    scene.obstacles = {ObstacleDescription{}};
    EXPECT_EQ(refused_key(scene), "obstacles");
    scene = {};
    scene.start.time = 1.0;
    EXPECT_EQ(refused_key(scene), "start.time");
    scene = {};
    scene.start.state = std::make_shared<const ClothState>();
    EXPECT_EQ(refused_key(scene), "start.state");
}

}  // namespace
}  // namespace weft::lab
