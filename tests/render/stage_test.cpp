// Where mast, ground and sun stand.
#include "render/stage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/mast.h"
#include "support/waving_cloth.h"

namespace weft {
namespace {

using test::WavingCloth;

Stage stage_of(const WavingCloth& cloth, bool mast = true) {
    RenderDescription render;
    render.mast = mast;
    return plan_stage(cloth.surface, cloth.rest, render);
}

WavingCloth moved(WavingCloth cloth, Vec3d by) {
    for (Vec3d& point : cloth.rest) point += by;
    return cloth;
}

/// The grid laid flat: its height becomes depth, its lower edge toward +z.
WavingCloth laid_flat(WavingCloth cloth) {
    for (Vec3d& point : cloth.rest) point = {point.x, 2.0, 2.0 - point.y};
    return cloth;
}

TEST(Stage, FlagFacesItsFrontAndStandsOnTheGround) {
    const Stage stage = stage_of(test::waving_grid(31, 21));
    EXPECT_NEAR(stage.front.z, 1.0, 1e-6);
    EXPECT_FALSE(stage.lying);
    EXPECT_NEAR(stage.size, std::hypot(1.5, 1.0), 1e-5);
    ASSERT_TRUE(stage.ground);
    EXPECT_EQ(*stage.ground, 0.0F);
    EXPECT_NEAR(glm::length(stage.to_sun), 1.0, 1e-6);
    EXPECT_GT(stage.to_sun.y, 0.5F);
}

TEST(Stage, MastStandsBesideTheLeftEdgeFromTheGroundToAboveTheCloth) {
    const Stage stage = stage_of(test::waving_grid(31, 21));
    ASSERT_TRUE(stage.mast);
    const Pole& mast = *stage.mast;
    EXPECT_FALSE(mast.level);
    EXPECT_NEAR(mast.foot.y, 0.0, 1e-6);
    EXPECT_GT(mast.top.y, 2.05F);
    EXPECT_LT(mast.top.y, 2.3F);
    EXPECT_NEAR(mast.foot.x, mast.top.x, 1e-6);
    EXPECT_LT(mast.foot.x + mast.radius, 0.0F);  // beside the cloth, not through it
    EXPECT_GT(mast.foot.x, -0.1F);
    ASSERT_EQ(mast.ties.size(), 2U);
    EXPECT_GT(mast.ties[0].y, 1.0F);
    EXPECT_LT(mast.ties[1].y, 2.0F);
}

TEST(Stage, MastOfALyingEdgeIsLevelAndLongerThanTheEdge) {
    const Stage stage = stage_of(laid_flat(test::waving_grid(31, 21)));
    ASSERT_TRUE(stage.mast);
    EXPECT_TRUE(stage.mast->level);
    EXPECT_GT(glm::distance(stage.mast->foot, stage.mast->top), 1.1F);
    EXPECT_NEAR(stage.mast->foot.y, stage.mast->top.y, 1e-6);
}

TEST(Stage, LyingClothIsSeenFromItsLowerEdge) {
    const Stage stage = stage_of(laid_flat(test::waving_grid(31, 21)), false);
    EXPECT_TRUE(stage.lying);
    EXPECT_FALSE(stage.mast);
    EXPECT_NEAR(stage.front.z, 1.0, 1e-6);
}

TEST(Stage, ReachHoldsTheClothHangingFromItsFastening) {
    const Stage flag = stage_of(test::waving_grid(31, 21));
    EXPECT_LE(flag.reach.low.x, -1.5F);  // blown the other way
    EXPECT_GT(flag.reach.low.y, 0.0F);   // limp: its far corner stays above 2 m - 1.05 x 1.803 m
    EXPECT_NEAR(flag.reach.low.y, 2.0 - 1.05 * std::hypot(1.5, 1.0), 0.02);
    const Stage sheet = stage_of(laid_flat(test::waving_grid(31, 21)), false);
    EXPECT_LE(sheet.reach.low.y, 2.0F - 1.0F);  // falls to hang below its upper edge
    EXPECT_LE(sheet.reach.low.z, -0.7F);        // and swings through
}

TEST(Stage, GroundLiesBelowAClothThatWouldPierceTheNaturalOne) {
    const Stage stage = stage_of(moved(test::waving_grid(31, 21), {0, -2, 0}));
    EXPECT_LT(*stage.ground, stage.reach.low.y);
    EXPECT_GT(*stage.ground, stage.reach.low.y - 0.3F);
}

TEST(Stage, GroundLiesNearAClothHighUp) {
    const Stage stage = stage_of(moved(test::waving_grid(31, 21), {0, 100, 0}));
    EXPECT_GT(*stage.ground, 99.0F);
    EXPECT_NEAR(stage.mast->foot.y, *stage.ground, 1e-4);
}

TEST(Stage, ClosedGarmentFacesForward) {
    const Stage stage = stage_of(test::waving_sleeve(24, 10), false);
    EXPECT_NEAR(glm::length(stage.front), 1.0, 1e-5);
    EXPECT_NEAR(stage.front.y, 0.0, 1e-6);
}

TEST(Stage, GroundCanBeLeftOut) {
    const WavingCloth cloth = test::waving_grid(5, 5);
    RenderDescription render;
    render.ground = false;
    EXPECT_FALSE(plan_stage(cloth.surface, cloth.rest, render).ground);
}

TEST(Mast, SolidIsClosedAndItsNormalsPointOutward) {
    const Stage stage = stage_of(test::waving_grid(31, 21));
    const Solid solid = build_mast(*stage.mast);
    ASSERT_EQ(solid.indices.size() % 3, 0U);
    std::size_t inward = 0, counted = 0;
    for (std::size_t i = 0; i < solid.indices.size(); i += 3) {
        const SolidVertex& a = solid.vertices[solid.indices[i]];
        const SolidVertex& b = solid.vertices[solid.indices[i + 1]];
        const SolidVertex& c = solid.vertices[solid.indices[i + 2]];
        const glm::vec3 across = glm::cross(b.position - a.position, c.position - a.position);
        if (glm::length(across) < 1e-9F) continue;  // the tip of a ball
        ++counted;
        inward += glm::dot(across, a.normal + b.normal + c.normal) < 0.0F;
    }
    EXPECT_GT(counted, 1000U);
    EXPECT_EQ(inward, 0U);
}

}  // namespace
}  // namespace weft
