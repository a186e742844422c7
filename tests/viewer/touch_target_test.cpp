#include "viewer/touch_target.h"

#include <gtest/gtest.h>

#include "shown_sheet.h"

namespace weft::viewer {
namespace {

TEST(TouchTarget, MeetsTheClothWhereItIsAndNothingBesideIt) {
    const ShownSheet sheet;
    const TouchTarget on = sheet.target(sheet.pixel({0.02F, -0.01F, 0.0F}));
    EXPECT_EQ(on.kind, PointerTarget::cloth);
    EXPECT_EQ(on.particle, ShownSheet::middle);
    EXPECT_NEAR(on.point.x, 0.02, 1e-3);
    EXPECT_NEAR(on.point.y, -0.01, 1e-3);
    EXPECT_EQ(sheet.target(sheet.pixel({0.7F, 0.0F, 0.0F})).kind, PointerTarget::nothing);
}

TEST(TouchTarget, APinIsMetWithinItsReachOnAndOffTheCloth) {
    const ShownSheet sheet;
    const glm::vec2 pin = sheet.pixel({0.5F, 0.5F, 0.0F});
    for (const glm::vec2 aside : {glm::vec2(-6, 5), glm::vec2(6, -5), glm::vec2(0, 0)}) {
        const TouchTarget met = sheet.target(pin + aside);
        EXPECT_EQ(met.kind, PointerTarget::pin);
        EXPECT_EQ(met.particle, ShownSheet::top_right);
    }
    EXPECT_EQ(sheet.target(pin + glm::vec2(10, 0)).kind, PointerTarget::nothing);
    EXPECT_EQ(sheet.target(pin + glm::vec2(-10, 2)).kind, PointerTarget::cloth);
}

TEST(TouchTarget, WhatIsHiddenIsNotMet) {
    ShownSheet sheet;
    sheet.shown.obstacles = {{SphereObstacle{{0.33, 0.33, 1.0}, 0.2}}};
    EXPECT_EQ(sheet.target(sheet.pixel({0.5F, 0.5F, 0.0F})).kind, PointerTarget::obstacle);
    sheet.shown.obstacles = {{SphereObstacle{{0.0, 0.0, -0.3}, 0.2}}};
    EXPECT_EQ(sheet.target(sheet.pixel({0.0F, 0.0F, 0.0F})).kind, PointerTarget::cloth);
}

TEST(TouchTarget, OfSpheresTheNearestIsMet) {
    ShownSheet sheet;
    sheet.shown.obstacles = {{PlaneObstacle{{0.0, 0.0, 1.5}, {0.0, 0.0, 1.0}}},
                             {SphereObstacle{{0.8, 0.0, -1.0}, 0.3}},
                             {SphereObstacle{{0.8, 0.0, 0.0}, 0.2}}};
    const TouchTarget met = sheet.target(sheet.pixel({0.75F, 0.0F, 0.0F}));
    EXPECT_EQ(met.kind, PointerTarget::obstacle);
    EXPECT_EQ(met.obstacle, 2U);
}

TEST(TouchTarget, APlaneIsMetByItsHandleOnly) {
    ShownSheet sheet;
    sheet.shown.obstacles = {{PlaneObstacle{{5.0, -0.6, 9.0}, {0.0, 2.0, 0.0}}}};
    const auto handles = plane_handles(sheet.shown.obstacles, sheet.shown.cloths[0].shape->stage);
    ASSERT_EQ(handles.size(), 1U);
    EXPECT_GT(handles[0].middle.y - handles[0].length, -0.6F) << "it stands on the plane";
    EXPECT_LT(handles[0].middle.y - handles[0].length, -0.57F);
    EXPECT_FLOAT_EQ(glm::length(handles[0].normal), 1.0F);
    const glm::vec3 tip = handles[0].middle + handles[0].length * handles[0].normal;
    EXPECT_EQ(sheet.target(sheet.pixel(tip)).kind, PointerTarget::obstacle);
    EXPECT_EQ(sheet.target(sheet.pixel(handles[0].middle) + glm::vec2(30, 0)).kind,
              PointerTarget::nothing);
}

TEST(TouchTarget, ARecordingCannotBeTouched) {
    ShownSheet sheet;
    sheet.shown.touchable = false;
    EXPECT_EQ(sheet.target(sheet.pixel({0.0F, 0.0F, 0.0F})).kind, PointerTarget::nothing);
}

TEST(TouchTarget, NearestPointOfALineIsThatOfASkewRay) {
    // The line along y through (1, 0, 0); the ray passes it at height 2, 3 behind.
    const Ray ray{{1.0, 2.0, 5.0}, {0.0, 0.0, -1.0}};
    const glm::dvec3 point = nearest_on_line(ray, {1.0, 0.0, 2.0}, {0.0, 1.0, 0.0});
    EXPECT_NEAR(glm::distance(point, {1.0, 2.0, 2.0}), 0.0, 1e-12);
    // Slanted: the foot of the common perpendicular, by hand.
    const Ray slanted{{0.0, 0.0, 0.0}, glm::normalize(glm::dvec3(1.0, 1.0, 0.0))};
    const glm::dvec3 foot = nearest_on_line(slanted, {2.0, 0.0, 1.0}, {0.0, 1.0, 0.0});
    EXPECT_NEAR(glm::distance(foot, {2.0, 2.0, 1.0}), 0.0, 1e-12);
    const glm::dvec3 kept = nearest_on_line(ray, {1.0, 0.0, 2.0}, {0.0, 0.0, 1.0});
    EXPECT_EQ(kept, glm::dvec3(1.0, 0.0, 2.0));
}

}  // namespace
}  // namespace weft::viewer
