// The automatic camera and the given one.
#include "render/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support/waving_cloth.h"
#include "weft/error.h"

namespace weft {
namespace {

using test::WavingCloth;

/// Where a point comes to lie in the picture: [-1, 1] across and upward.
glm::vec3 projected(const Camera& camera, const RenderDescription& render, glm::vec3 point) {
    const float aspect = static_cast<float>(render.size[0]) / static_cast<float>(render.size[1]);
    const glm::vec4 clip = camera.world_to_clip(aspect) * glm::vec4(point, 1.0F);
    return glm::vec3(clip) / clip.w;
}

Camera camera_of(const WavingCloth& cloth, const RenderDescription& render) {
    return choose_camera(plan_stage(cloth.surface, cloth.rest, render), render);
}

class Framing : public testing::TestWithParam<std::array<int, 2>> {};

INSTANTIATE_TEST_SUITE_P(Sizes, Framing,
                         testing::Values(std::array{1280, 720}, std::array{720, 1280},
                                         std::array{500, 500}, std::array{1600, 200}));

TEST_P(Framing, HoldsTheWavingFlagInEveryFrame) {
    WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render;
    render.size = GetParam();
    const Camera camera = camera_of(cloth, render);
    for (std::size_t frame = 0; frame < 30; ++frame) {
        for (const Vec3d& position : cloth.frame(frame).positions) {
            const glm::vec3 place = projected(camera, render, to_glm(position));
            ASSERT_LT(std::abs(place.x), 1.0F) << "frame " << frame;
            ASSERT_LT(std::abs(place.y), 1.0F) << "frame " << frame;
            ASSERT_LT(std::abs(place.z), 1.0F) << "frame " << frame;
        }
    }
}

TEST_P(Framing, HoldsASheetThatFallsAndSwings) {
    const WavingCloth hanging = test::waving_grid(21, 21);
    WavingCloth lying = hanging;
    for (Vec3d& point : lying.rest) point = {point.x, 2.0, 2.0 - point.y};
    RenderDescription render;
    render.size = GetParam();
    render.mast = false;
    const Camera camera = camera_of(lying, render);
    for (double angle = 0.0; angle < 2.7; angle += 0.1) {  // about its upper edge, stiff as a door
        for (const Vec3d& point : lying.rest) {
            const Vec3d swung{point.x, 2.0 - point.z * std::sin(angle), point.z * std::cos(angle)};
            const glm::vec3 place = projected(camera, render, to_glm(swung));
            ASSERT_LT(std::abs(place.x), 1.0F) << "angle " << angle;
            ASSERT_LT(std::abs(place.y), 1.0F) << "angle " << angle;
        }
    }
}

TEST_P(Framing, FillsThePicture) {
    const WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render;
    render.size = GetParam();
    const Stage stage = plan_stage(cloth.surface, cloth.rest, render);
    const Camera camera = choose_camera(stage, render);
    float across = 0.0F, upward = 0.0F;
    for (const glm::vec3& corner : stage.view) {
        const glm::vec3 place = projected(camera, render, corner);
        across = std::max(across, std::abs(place.x));
        upward = std::max(upward, std::abs(place.y));
    }
    EXPECT_NEAR(std::max(across, upward), 0.95F, 0.01F);
}

TEST(Camera, FlagTakesAtLeastAFifthOfTheWidePicture) {
    const WavingCloth cloth = test::waving_grid(31, 21);
    const RenderDescription render;
    const Camera camera = camera_of(cloth, render);
    const auto corner = [&](std::size_t i) {
        return projected(camera, render, to_glm(cloth.rest[i]));
    };
    const float width = corner(30).x - corner(0).x, height = corner(0).y - corner(31 * 20).y;
    EXPECT_GT(width * height / 4.0F, 0.2F);  // the picture measures 2 x 2
}

TEST(Camera, SeesTheFront) {
    const WavingCloth cloth = test::waving_grid(31, 21);
    EXPECT_GT(camera_of(cloth, {}).eye.z, 1.0F);
    EXPECT_GT(camera_of(cloth, {}).eye.y, 0.0F);  // above the ground
}

TEST(Camera, StandsExactlyWhereItIsTold) {
    const WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render;
    render.camera = Vec3d{3.0, 1.25, 4.0};
    Camera camera = camera_of(cloth, render);
    EXPECT_EQ(camera.eye, glm::vec3(3.0F, 1.25F, 4.0F));
    EXPECT_NEAR(glm::distance(camera.target, glm::vec3(0.75F, 1.5F, 0.0F)), 0.0, 1e-6);
    render.target = Vec3d{1.0, 1.0, 0.0};
    render.field_of_view = 50.0;
    camera = camera_of(cloth, render);
    EXPECT_EQ(camera.target, glm::vec3(1.0F, 1.0F, 0.0F));
    EXPECT_EQ(camera.field_of_view, 50.0F);
    const glm::vec3 centre = projected(camera, render, camera.target);
    EXPECT_NEAR(centre.x, 0.0, 1e-5);
    EXPECT_NEAR(centre.y, 0.0, 1e-5);
}

TEST(Camera, KeepsATargetInTheMiddle) {
    const WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render;
    render.target = Vec3d{0.2, 1.9, 0.1};
    const Camera camera = camera_of(cloth, render);
    const glm::vec3 centre = projected(camera, render, {0.2F, 1.9F, 0.1F});
    EXPECT_NEAR(centre.x, 0.0, 1e-4);
    EXPECT_NEAR(centre.y, 0.0, 1e-4);
    for (const Vec3d& point : cloth.rest) {
        EXPECT_LT(std::abs(projected(camera, render, to_glm(point)).x), 1.0F);
        EXPECT_LT(std::abs(projected(camera, render, to_glm(point)).y), 1.0F);
    }
}

TEST(Camera, CanLookStraightDown) {
    const WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render;
    render.camera = Vec3d{1.0, 5.0, 0.0};
    render.target = Vec3d{1.0, 1.0, 0.0};
    const Camera camera = camera_of(cloth, render);
    EXPECT_NEAR(projected(camera, render, {1.5F, 1.0F, 0.0F}).y, 0.0, 1e-5);
    EXPECT_GT(projected(camera, render, {1.5F, 1.0F, 0.0F}).x, 0.05F);
}

TEST(Camera, RefusesToLookAtItself) {
    const WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render;
    render.camera = render.target = Vec3d{1.0, 1.0, 3.0};
    try {
        camera_of(cloth, render);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_EQ(error.place().key, "render.camera");
    }
}

}  // namespace
}  // namespace weft
