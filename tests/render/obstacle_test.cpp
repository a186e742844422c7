// Obstacles: where they stand in a stage, and how they are seen.
#include <gtest/gtest.h>

#include <cmath>

#include "render/canvas.h"
#include "render/obstacle_solids.h"

namespace weft {
namespace {

using test::brightness;
using test::Canvas;
using test::DrawnCloth;
using test::Pixel;

ObstacleDescription ball(Vec3d centre, double radius) {
    return {SphereObstacle{centre, radius}, 0.4, 0.005};
}
ObstacleDescription plane(Vec3d point, Vec3d normal) {
    return {PlaneObstacle{point, normal}, 0.4, 0.005};
}

TEST(Obstacles, LevelPlaneIsTheFloorAndTheHighestCounts) {
    EXPECT_EQ(level_height({{1, 0.25, 2}, {0, 3, 0}}), 0.25F);
    EXPECT_FALSE(level_height({{0, 0.25, 0}, {0, -1, 0}}));  // a ceiling
    EXPECT_FALSE(level_height({{0, 0.25, 0}, {0.02, 1, 0}}));
    Stage stage;
    EXPECT_FALSE(floor_height(stage));
    stage.ground = -0.5F;
    EXPECT_EQ(floor_height(stage), -0.5F);
    stage.obstacles = {plane({0, 0.1, 0}, {0, 1, 0}), plane({0, 0.3, 0}, {0, 1, 0}),
                       plane({0, 0.9, 0}, {1, 1, 0}), ball({0, 5, 0}, 1)};
    EXPECT_EQ(floor_height(stage), 0.3F);
}

TEST(Obstacles, MastStandsOnTheFloorThatAPlaneMakes) {
    const auto cloth = test::waving_grid(11, 7);
    const std::vector<ObstacleDescription> obstacles{plane({0, 0.4, 0}, {0, 1, 0})};
    const Stage stage = plan_stage(cloth.surface, cloth.rest, {}, obstacles);
    ASSERT_TRUE(stage.mast);
    EXPECT_NEAR(stage.mast->foot.y, 0.4F, 1e-5F);
    EXPECT_EQ(stage.ground, 0.0F);  // where the cloth alone would have it
    EXPECT_EQ(stage.obstacles.size(), 1U);
    RenderDescription bare;
    bare.ground = false;
    EXPECT_EQ(floor_height(plan_stage(cloth.surface, cloth.rest, bare, obstacles)), 0.4F);
}

TEST(Obstacles, StageWithoutThemIsAsEver) {
    const auto cloth = test::waving_grid(11, 7);
    const Stage without = plan_stage(cloth.surface, cloth.rest, {});
    const Stage with = plan_stage(cloth.surface, cloth.rest, {},
                                  std::vector<ObstacleDescription>{plane({0, 0.0, 0}, {0, 1, 0})});
    EXPECT_EQ(without.view, with.view);
}

TEST(Obstacles, AutomaticCameraShowsAllOfABall) {
    const auto cloth = test::waving_grid(11, 7);
    const std::vector<ObstacleDescription> obstacles{ball({3.5, 0.6, 0.4}, 0.6)};
    RenderDescription render;
    const Stage stage = plan_stage(cloth.surface, cloth.rest, render, obstacles);
    const Camera camera = choose_camera(stage, render);
    const auto aspect = static_cast<float>(render.size[0]) / static_cast<float>(render.size[1]);
    const glm::mat4 to_clip = camera.world_to_clip(aspect);
    for (int i = 0; i < 200; ++i) {
        const float height = -1.0F + 0.01F * static_cast<float>(i);
        const float around = 2.4F * static_cast<float>(i), side = std::sqrt(1 - height * height);
        const glm::vec3 way{side * std::cos(around), height, side * std::sin(around)};
        const glm::vec4 clip = to_clip * glm::vec4(glm::vec3(3.5F, 0.6F, 0.4F) + 0.6F * way, 1.0F);
        EXPECT_LT(std::abs(clip.x), clip.w);
        EXPECT_LT(std::abs(clip.y), clip.w);
    }
}

TEST(Obstacles, ClothThatLiesOverALargeBallIsNotExpectedToSwing) {
    auto cloth = test::waving_grid(11, 7);
    for (Vec3d& point : cloth.rest) point = {point.x, 1.2, 2.0 - point.y};
    RenderDescription render;
    render.mast = false;
    const auto view_box = [&](const ObstacleDescription& obstacle) {
        const Stage stage = plan_stage(cloth.surface, cloth.rest, render, std::vector{obstacle});
        EXPECT_TRUE(stage.lying);
        Box box{stage.view.front(), stage.view.front()};
        for (const glm::vec3& point : stage.view) box = box.grown_to(point);
        return box;
    };
    const Box over = view_box(ball({0.75, 0.5, 0.5}, 0.5));
    EXPECT_NEAR(over.low.z, 0.0F, 1e-5F);  // the cloth as it lies, and what is below it
    EXPECT_NEAR(over.high.z, 1.0F, 1e-5F);
    const Box small = view_box(ball({0.75, 0.1, 0.5}, 0.05));
    EXPECT_LT(small.low.z, -0.5F);  // where it swings to
    const Box slope = view_box(plane({0.75, 0.8, 0.5}, {0.5, 1.0, 0.0}));
    EXPECT_NEAR(slope.high.z, 1.0F, 1e-5F);
    const Box floor = view_box(plane({0.75, 0.8, 0.5}, {0.0, 1.0, 0.0}));
    EXPECT_LT(floor.low.z, -0.5F);
}

TEST(Obstacles, BallIsRoundWithNormalsOutward) {
    Stage stage;
    stage.obstacles = {ball({1, 2, 3}, 0.5)};
    for (const bool fine : {true, false}) {
        const Solid solid = build_obstacles(stage, fine);
        ASSERT_GE(solid.vertices.size(), fine ? 64U * 32U : 32U * 16U);
        for (const SolidVertex& vertex : solid.vertices) {
            EXPECT_NEAR(glm::distance(vertex.position, {1, 2, 3}), 0.5F, 1e-5F);
            EXPECT_NEAR(glm::distance(vertex.position, glm::vec3(1, 2, 3) + 0.5F * vertex.normal),
                        0.0F, 1e-5F);
        }
        const auto box = bounds_of(solid);
        ASSERT_TRUE(box);
        EXPECT_NEAR(box->low.y, 1.5F, 1e-5F);
        EXPECT_NEAR(box->high.y, 2.5F, 1e-5F);
    }
}

TEST(Obstacles, PlateLiesInItsPlaneAroundTheStageAndAFloorIsNoPlate) {
    Stage stage;
    stage.rest = {{0, 1, 0}, {1, 2, 0}};
    stage.obstacles = {plane({4, 0.5, -3}, {0.4, 2, -0.3}), plane({0, 0, 0}, {0, 1, 0})};
    const Solid solid = build_obstacles(stage, true);
    ASSERT_FALSE(solid.vertices.empty());
    const glm::vec3 normal = glm::normalize(glm::vec3(0.4F, 2.0F, -0.3F));
    glm::vec3 sum(0.0F);
    for (const SolidVertex& vertex : solid.vertices) {
        EXPECT_NEAR(glm::dot(vertex.position - glm::vec3(4, 0.5F, -3), normal), 0.0F, 1e-4F);
        EXPECT_NEAR(glm::distance(vertex.normal, normal), 0.0F, 1e-5F);
        sum += vertex.position;
    }
    const glm::vec3 middle = sum / static_cast<float>(solid.vertices.size());
    const glm::vec3 way = glm::vec3(0.5F, 1.5F, 0.0F) - middle;
    EXPECT_NEAR(glm::length(way - glm::dot(way, normal) * normal), 0.0F, 1e-4F);
    stage.obstacles = {plane({0, 0, 0}, {0, 1, 0})};
    EXPECT_TRUE(build_obstacles(stage, true).vertices.empty());
    EXPECT_FALSE(bounds_of(Solid{}));
}

TEST(Obstacles, BallIsSeenWhereItStandsAndMoves) {
    const Canvas canvas(480, 270);
    DrawnCloth drawn(test::waving_grid(11, 7),
                     DrawnCloth::seen_from({0.75, 1.2, 4.5}, {0.75, 1.0, 0.0}));
    const glm::vec3 here{0.2F, 0.4F, 0.6F}, there{1.3F, 0.4F, 0.6F};
    for (const Effort effort : {Effort::full, Effort::quick}) {
        const DrawOptions options{true, true, effort, 1};
        std::vector<std::vector<Pixel>> pictures;
        for (const glm::vec3& place : {here, there}) {
            drawn.stage.obstacles = {ball({place.x, place.y, place.z}, 0.2)};
            drawn.renderer.set_stage(drawn.stage);
            pictures.push_back(drawn.draw(canvas, drawn.at_rest(), options));
        }
        const std::size_t first = canvas.place_of(here, drawn.camera);
        const std::size_t second = canvas.place_of(there, drawn.camera);
        EXPECT_GT(pictures[0][first].r, 1.4F * pictures[0][first].b);  // of clay
        EXPECT_LT(pictures[0][second].r, 1.2F * pictures[0][second].b);
        EXPECT_GT(pictures[1][second].r, 1.4F * pictures[1][second].b);
        EXPECT_LT(pictures[1][first].r, 1.2F * pictures[1][first].b);
    }
}

TEST(Obstacles, BallCastsAShadowOnTheGround) {
    const Canvas canvas(480, 270);
    const glm::vec3 centre{0.75F, 0.6F, 1.2F};
    DrawnCloth drawn(test::waving_grid(11, 7),
                     DrawnCloth::seen_from({0.75, 3.0, 4.5}, {0.75, 0.3, 0.5}),
                     {ball({0.75, 0.6, 1.2}, 0.2)});
    const glm::vec3 shadow = centre - (centre.y / drawn.stage.to_sun.y) * drawn.stage.to_sun;
    const std::size_t place = canvas.place_of(shadow, drawn.camera);
    for (const Effort effort : {Effort::full, Effort::quick}) {
        const auto shaded = drawn.draw(canvas, drawn.at_rest(), {false, true, effort, 1});
        const auto lit = drawn.draw(canvas, drawn.at_rest(), {false, false, effort, 1});
        EXPECT_LT(brightness(shaded[place]), 0.7F * brightness(lit[place]));
    }
}

TEST(Obstacles, PlateIsSeenFromBothSides) {
    const Canvas canvas(480, 270);
    for (const double side : {1.0, -1.0}) {
        DrawnCloth drawn(test::waving_grid(11, 7),
                         DrawnCloth::seen_from({0.75, 1.5, 4.0 * side}, {0.75, 1.5, 0.0}));
        const std::size_t middle = canvas.place_of({0.75F, 1.5F, 0.0F}, drawn.camera);
        for (const Effort effort : {Effort::full, Effort::quick}) {
            const auto without = drawn.draw(canvas, drawn.at_rest(), {true, true, effort, 1});
            drawn.stage.obstacles = {plane({0, 0, 0.3 * side}, {0.0, 0.1, 1.0})};
            drawn.renderer.set_stage(drawn.stage);
            const auto with = drawn.draw(canvas, drawn.at_rest(), {true, true, effort, 1});
            drawn.stage.obstacles.clear();
            drawn.renderer.set_stage(drawn.stage);
            EXPECT_GT(without[middle].r, 1.5F * without[middle].b);  // the cloth
            EXPECT_LT(with[middle].r, 1.25F * with[middle].b);       // the plate before it
            EXPECT_GT(brightness(with[middle]), 30.0F);
        }
    }
}

}  // namespace
}  // namespace weft
