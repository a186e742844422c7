#include "viewer/cloth_touch.h"

#include <gtest/gtest.h>

#include "shown_sheet.h"

namespace weft::viewer {
namespace {

/// A hand with a mouse over the sheet, and all that it asked for.
struct Hand : ShownSheet {
    std::vector<std::vector<Grip>> grips;
    std::vector<std::size_t> gripped_cloths, toggled, moved_pins, moved_obstacles;
    std::vector<Vec3d> toggled_at;
    Vec3d pin_shift{}, obstacle_shift{};
    int ended = 0;
    double time = 0.0;
    Pointer pointer;
    ClothTouch touch{requests()};

    TouchRequests requests() {
        return {[this](std::size_t cloth, std::vector<Grip> wanted) {
                    gripped_cloths.push_back(cloth);
                    grips.push_back(std::move(wanted));
                },
                [this](std::size_t particle, Vec3d at) {
                    toggled.push_back(particle);
                    toggled_at.push_back(at);
                },
                [this](std::size_t particle, Vec3d shift) {
                    moved_pins.push_back(particle);
                    pin_shift += shift;
                },
                [this](std::size_t obstacle, Vec3d shift) {
                    moved_obstacles.push_back(obstacle);
                    obstacle_shift += shift;
                },
                [this] { ++ended; }};
    }

    void update() {
        time += 0.05;
        pointer.time = time;
        touch.update(pointer, shown, areas, camera);
        for (Pointer::Button& button : pointer.buttons) button.pressed = button.released = false;
        pointer.wheel = 0.0F;
    }
    void move_to(glm::vec2 pixel) {
        pointer.pixel = pixel;
        update();
    }
    void press(glm::vec2 pixel, std::size_t button = 0) {
        pointer.pixel = pixel;
        pointer.buttons[button] = {true, false, true};
        update();
    }
    void release(std::size_t button = 0) {
        pointer.buttons[button] = {false, true, false};
        update();
    }
    [[nodiscard]] bool asked_for_nothing() const {
        return grips.empty() && toggled.empty() && moved_pins.empty() && moved_obstacles.empty();
    }
};

TEST(ClothTouch, ADragOnTheClothGripsThePatchUntilItIsReleased) {
    Hand hand;
    hand.press(hand.pixel({0.0F, 0.0F, 0.0F}));
    EXPECT_TRUE(hand.grips.empty()) << "it may yet be a click";
    hand.move_to(hand.pixel({0.3F, 0.1F, 0.0F}));
    ASSERT_EQ(hand.grips.size(), 1U);
    ASSERT_FALSE(hand.grips[0].empty());
    const auto held = std::find_if(hand.grips[0].begin(), hand.grips[0].end(),
                                   [](const Grip& g) { return g.particle == ShownSheet::middle; });
    ASSERT_NE(held, hand.grips[0].end());
    EXPECT_NEAR(held->point.x, 0.3, 2e-3);
    EXPECT_NEAR(held->point.y, 0.1, 2e-3);
    EXPECT_NEAR(held->point.z, 0.0, 1e-5);
    ASSERT_TRUE(hand.touch.hold().has_value());
    EXPECT_EQ(hand.touch.hold()->particle, ShownSheet::middle);
    hand.update();
    EXPECT_EQ(hand.grips.size(), 1U) << "the hand rests";
    hand.release();
    ASSERT_EQ(hand.grips.size(), 2U);
    EXPECT_TRUE(hand.grips[1].empty());
    EXPECT_FALSE(hand.touch.hold().has_value());
    EXPECT_EQ(hand.ended, 1);
    EXPECT_TRUE(hand.toggled.empty());
}

TEST(ClothTouch, ThePatchIsTakenAsItWasWhenTheHandClosed) {
    Hand hand;
    hand.press(hand.pixel({0.0F, 0.0F, 0.0F}));
    for (Vec3d& position : hand.positions) position.z += 0.4;  // it flies on meanwhile
    hand.move_to(hand.pixel({0.3F, 0.1F, 0.0F}));
    ASSERT_EQ(hand.grips.size(), 1U);
    for (const Grip& grip : hand.grips[0]) EXPECT_NEAR(grip.point.z, 0.0, 1e-5);
}

TEST(ClothTouch, HoldingStillIsNoClickEither) {
    Hand hand;
    hand.press(hand.pixel({0.0F, 0.0F, 0.0F}));
    for (int n = 0; n < 10; ++n) hand.update();
    EXPECT_EQ(hand.grips.size(), 1U);
    hand.release();
    EXPECT_TRUE(hand.toggled.empty());
}

TEST(ClothTouch, AClickPinsTheParticleAndPullsAtNothing) {
    Hand hand;
    hand.press(hand.pixel({0.11F, -0.2F, 0.0F}));
    hand.release();
    ASSERT_EQ(hand.toggled.size(), 1U);
    EXPECT_EQ(hand.toggled[0], 7U * ShownSheet::side + 6U);
    EXPECT_NEAR(hand.toggled_at[0].x, 0.1, 1e-12);
    EXPECT_TRUE(hand.grips.empty());
    EXPECT_EQ(hand.ended, 1);
}

TEST(ClothTouch, APressAndReleaseWithinOneFrameIsAClick) {
    Hand hand;
    hand.pointer.pixel = hand.pixel({0.5F, 0.5F, 0.0F});
    hand.pointer.buttons[0] = {true, true, false};
    hand.update();
    ASSERT_EQ(hand.toggled.size(), 1U);
    EXPECT_EQ(hand.toggled[0], ShownSheet::top_right);
    EXPECT_EQ(hand.touch.gesture(), Gesture::none);
}

TEST(ClothTouch, APinFollowsThePointerInThePlaneOfThePicture) {
    Hand hand;
    hand.press(hand.pixel({0.5F, 0.5F, 0.0F}));
    hand.move_to(hand.pixel({0.4F, 0.55F, 0.0F}));
    hand.move_to(hand.pixel({0.2F, 0.3F, 0.0F}));
    hand.release();
    ASSERT_FALSE(hand.moved_pins.empty());
    EXPECT_EQ(hand.moved_pins[0], ShownSheet::top_right);
    EXPECT_NEAR(hand.pin_shift.x, -0.3, 1e-4);
    EXPECT_NEAR(hand.pin_shift.y, -0.2, 1e-4);
    EXPECT_NEAR(hand.pin_shift.z, 0.0, 1e-5);
    EXPECT_TRUE(hand.toggled.empty());
    EXPECT_EQ(hand.ended, 1);
}

TEST(ClothTouch, CancellingPutsBackWhatWasDragged) {
    Hand hand;
    hand.press(hand.pixel({0.5F, 0.5F, 0.0F}));
    hand.move_to(hand.pixel({0.2F, 0.3F, 0.0F}));
    hand.touch.cancel();
    EXPECT_NEAR(length(hand.pin_shift), 0.0, 1e-12);
    EXPECT_EQ(hand.ended, 1);
    hand.move_to(hand.pixel({0.0F, 0.0F, 0.0F}));
    hand.release();
    EXPECT_NEAR(length(hand.pin_shift), 0.0, 1e-12);
    EXPECT_TRUE(hand.toggled.empty());
    hand.touch.cancel();
    EXPECT_EQ(hand.ended, 1) << "nothing was held";
}

TEST(ClothTouch, ASphereMovesWithThePointerAndAPlaneAlongItsNormal) {
    Hand hand;
    hand.shown.obstacles = {{SphereObstacle{{0.8, 0.0, 0.0}, 0.2}},
                            {PlaneObstacle{{0.0, -0.5, 0.0}, {0.0, 1.0, 0.0}}}};
    hand.press(hand.pixel({0.8F, 0.0F, 0.2F}));
    hand.move_to(hand.pixel({0.9F, 0.3F, 0.2F}));
    hand.release();
    ASSERT_EQ(hand.moved_obstacles, (std::vector<std::size_t>{0}));
    EXPECT_NEAR(hand.obstacle_shift.x, 0.1, 2e-3);
    EXPECT_NEAR(hand.obstacle_shift.y, 0.3, 2e-3);
    hand.obstacle_shift = {};
    const auto handle = plane_handles(hand.shown.obstacles, hand.shown.cloths[0].shape->stage)[0];
    hand.press(hand.pixel(handle.middle));
    hand.move_to(hand.pixel(handle.middle + glm::vec3(0.05F, 0.1F, 0.0F)));
    hand.release();
    EXPECT_EQ(hand.moved_obstacles.back(), 1U);
    EXPECT_EQ(hand.obstacle_shift.x, 0.0);
    EXPECT_NEAR(hand.obstacle_shift.y, 0.1, 5e-3);
    EXPECT_EQ(hand.obstacle_shift.z, 0.0);
}

TEST(ClothTouch, BesideTheClothTheCameraTurnsAndOtherButtonsPan) {
    Hand hand;
    const glm::vec3 eye = hand.camera.camera().eye;
    hand.press(hand.pixel({0.7F, 0.0F, 0.0F}));
    hand.move_to(hand.pointer.pixel + glm::vec2(60, 20));
    hand.release();
    EXPECT_GT(glm::distance(hand.camera.camera().eye, eye), 0.1F);
    EXPECT_NEAR(glm::length(hand.camera.camera().target), 0.0F, 1e-5F);
    EXPECT_TRUE(hand.touch.moved_camera());
    for (const std::size_t button : {1U, 2U}) {
        const glm::vec3 target = hand.camera.camera().target;
        hand.press(hand.pixel({0.0F, 0.0F, 0.0F}), button);
        hand.move_to(hand.pointer.pixel + glm::vec2(60, 20));
        hand.release(button);
        EXPECT_GT(glm::distance(hand.camera.camera().target, target), 0.05F);
    }
    EXPECT_TRUE(hand.asked_for_nothing());
}

TEST(ClothTouch, TheWheelZoomsAtTheCursor) {
    Hand hand;
    const glm::vec3 corner(0.5F, 0.5F, 0.0F);
    const glm::vec2 pixel = hand.pixel(corner);
    hand.pointer.wheel = 3.0F;
    hand.move_to(pixel);
    EXPECT_LT(glm::length(hand.camera.camera().eye), 2.6F);
    EXPECT_NEAR(glm::distance(hand.pixel(corner), pixel), 0.0F, 0.5F);
}

TEST(ClothTouch, OverAPanelNothingBeginsButADragGoesOn) {
    Hand hand;
    hand.pointer.free = false;
    hand.pointer.wheel = 3.0F;
    hand.press(hand.pixel({0.0F, 0.0F, 0.0F}));
    EXPECT_EQ(hand.touch.gesture(), Gesture::none);
    EXPECT_FALSE(hand.touch.moved_camera());
    hand.release();
    hand.pointer.free = true;
    hand.press(hand.pixel({0.0F, 0.0F, 0.0F}));
    hand.pointer.free = false;
    hand.move_to({0.0F, 0.0F});
    EXPECT_EQ(hand.touch.gesture(), Gesture::grab_cloth);
    EXPECT_EQ(hand.grips.size(), 1U);
    hand.release();
    EXPECT_EQ(hand.touch.gesture(), Gesture::none);
}

TEST(ClothTouch, AReleaseThatNobodySawEndsTheGesture) {
    Hand hand;
    hand.press(hand.pixel({0.0F, 0.0F, 0.0F}));
    hand.move_to(hand.pixel({0.3F, 0.1F, 0.0F}));
    hand.pointer.buttons[0].down = false;  // the window lost the mouse
    hand.update();
    EXPECT_EQ(hand.touch.gesture(), Gesture::none);
    EXPECT_TRUE(hand.grips.back().empty());
}

TEST(ClothTouch, AnotherClothUnderTheHandLetsGo) {
    Hand hand;
    hand.press(hand.pixel({0.0F, 0.0F, 0.0F}));
    hand.move_to(hand.pixel({0.3F, 0.1F, 0.0F}));
    hand.positions.resize(50);  // the resolution was changed
    hand.shown.cloths[0].frame.positions = hand.positions;
    auto shape = std::make_shared<ClothShape>(*hand.shown.cloths[0].shape);
    shape->surface.triangles.clear();
    shape->pinned.clear();
    hand.shown.cloths[0].shape = shape;
    hand.update();
    EXPECT_EQ(hand.touch.gesture(), Gesture::none);
    EXPECT_TRUE(hand.grips.back().empty());
}

TEST(ClothTouch, OfSeveralClothsTheOneUnderTheCursorIsGripped) {
    Hand hand;
    hand.shown.cloths.push_back(hand.shown.cloths[0]);
    hand.areas = split_area({0, 0, 1200, 500}, 2);
    hand.press(hand.pixel({0.0F, 0.0F, 0.0F}, 1));
    hand.move_to(hand.pixel({0.2F, 0.0F, 0.0F}, 1));
    ASSERT_EQ(hand.gripped_cloths, (std::vector<std::size_t>{1}));
    hand.move_to(hand.pixel({0.0F, 0.0F, 0.0F}, 0));
    EXPECT_EQ(hand.gripped_cloths.back(), 1U) << "the drag left its area";
    hand.shown.cloths.pop_back();
    hand.areas = split_area({0, 0, 1200, 500}, 1);
    hand.update();
    EXPECT_EQ(hand.touch.gesture(), Gesture::none);
}

TEST(ClothTouch, OnFineScreensAClickMayStrayByMorePixels) {
    Hand hand;
    hand.pointer.scale = 2.0F;
    hand.press(hand.pixel({0.0F, 0.0F, 0.0F}));
    hand.move_to(hand.pointer.pixel + glm::vec2(7, 0));
    hand.release();
    EXPECT_EQ(hand.toggled.size(), 1U);
}

}  // namespace
}  // namespace weft::viewer
