#include "viewer/view_camera.h"

#include <gtest/gtest.h>

#include "shown_sheet.h"

namespace weft::viewer {
namespace {

/// A stage that an automatic camera can frame: a unit sheet at x = `at`.
Stage stage_at(float at, float size = 1.0F) {
    Stage stage;
    stage.rest = {{at - 0.5F * size, 0.0F, 0.0F}, {at + 0.5F * size, size, 0.0F}};
    stage.reach = stage.rest;
    for (const glm::vec3& corner : stage.rest.corners()) stage.view.push_back(corner);
    stage.size = 1.4F * size;
    return stage;
}

constexpr ViewArea wide{0, 0, 1280, 720}, square{0, 0, 600, 600};

void expect_shown(const Camera& camera, const ViewArea& area, const Box& box) {
    for (const glm::vec3& corner : box.corners()) {
        const auto pixel = pixel_of(area, camera, corner);
        ASSERT_TRUE(pixel.has_value());
        EXPECT_TRUE(area.contains(*pixel)) << pixel->x << ", " << pixel->y;
    }
}

TEST(ViewCamera, ShowsAllOfTheClothInAreasOfAnyProportions) {
    const Stage stage = stage_at(2.0F);
    ViewCamera camera;
    for (const ViewArea& area : {wide, square, ViewArea{0, 0, 300, 900}, wide}) {
        camera.follow(stage, {}, area, [&] { return stage.rest; });
        expect_shown(camera.camera(), area, stage.rest);
    }
}

TEST(ViewCamera, DrawsBackAnEyeThatTheSceneFixes) {
    RenderDescription render;
    render.camera = Vec3d{2.0, 0.5, 5.0};
    render.target = Vec3d{2.0, 0.5, 0.0};
    const Stage stage = stage_at(2.0F);
    EXPECT_FLOAT_EQ(camera_for(stage, render, wide).eye.z, 5.0F);
    EXPECT_FLOAT_EQ(camera_for(stage, render, square).eye.z, 5.0F * 16.0F / 9.0F);
}

TEST(ViewCamera, StaysWhereTheMousePutIt) {
    const Stage stage = stage_at(2.0F);
    ViewCamera camera;
    camera.follow(stage, {}, wide, [&] { return stage.rest; });
    camera.orbit().orbit({100.0F, 20.0F}, 720.0F);
    camera.keep();
    const glm::vec3 eye = camera.camera().eye;
    camera.follow(stage, {}, ViewArea{0, 0, 1300, 700}, [&] { return stage.rest; });
    EXPECT_EQ(camera.camera().eye, eye);
    camera.follow(stage_at(2.1F), {}, wide, [&] { return stage.rest; });
    EXPECT_EQ(camera.camera().eye, eye) << "the cloth was made a little larger";
    camera.follow(stage_at(4.0F), {}, wide, [&] { return stage_at(4.0F).rest; });
    EXPECT_NE(camera.camera().eye, eye) << "another cloth, elsewhere";
}

TEST(ViewCamera, ObstaclesAndPinsThatMoveDoNotMoveIt) {
    Stage stage = stage_at(2.0F);
    ViewCamera camera;
    camera.follow(stage, {}, wide, [&] { return stage.rest; });
    const glm::vec3 eye = camera.camera().eye;
    stage.view.emplace_back(9.0F, 9.0F, 9.0F);
    camera.follow(stage, {}, wide, [&] { return stage.rest; });
    EXPECT_EQ(camera.camera().eye, eye);
}

TEST(ViewCamera, FramesTheClothFromTheSameSide) {
    const Stage stage = stage_at(2.0F);
    ViewCamera camera;
    camera.follow(stage, {}, wide, [&] { return stage.rest; });
    camera.orbit().orbit({300.0F, 80.0F}, 720.0F);
    camera.orbit().pan({900.0F, 0.0F}, 720.0F);
    camera.keep();
    const glm::vec3 before = glm::normalize(camera.camera().target - camera.camera().eye);
    const Box fallen{{2.0F, -3.0F, -1.0F}, {3.0F, -2.0F, 1.0F}};
    camera.frame_cloth();
    camera.follow(stage, {}, wide, [&] { return fallen; });
    expect_shown(camera.camera(), wide, fallen);
    const glm::vec3 after = glm::normalize(camera.camera().target - camera.camera().eye);
    EXPECT_NEAR(glm::distance(before, after), 0.0F, 1e-4F);
}

TEST(ViewCamera, ClothsThatComeBesideAreShownWhole) {
    const Stage stage = stage_at(2.0F);
    ViewCamera camera;
    camera.follow(stage, {}, wide, [&] { return stage.rest; });
    camera.orbit().orbit({30.0F, 8.0F}, 720.0F);
    camera.keep();
    const ViewArea half{0, 0, 400, 720};
    camera.follow(stage, {}, half, [&] { return stage.rest; });
    expect_shown(camera.camera(), half, stage.rest);
}

TEST(ViewCamera, ResetGivesTheScenesOwnAgain) {
    const Stage stage = stage_at(2.0F);
    ViewCamera camera;
    camera.follow(stage, {}, wide, [&] { return stage.rest; });
    const glm::vec3 eye = camera.camera().eye;
    camera.orbit().orbit({300.0F, 80.0F}, 720.0F);
    camera.keep();
    camera.reset();
    camera.follow(stage, {}, wide, [&] { return stage.rest; });
    EXPECT_EQ(camera.camera().eye, eye);
}

}  // namespace
}  // namespace weft::viewer
