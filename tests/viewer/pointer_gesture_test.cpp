// What presses and movements of the mouse come to.
#include "viewer/pointer_gesture.h"

#include <gtest/gtest.h>

namespace weft::viewer {
namespace {

TEST(PointerGesture, IsDecidedByButtonAndTarget) {
    const auto gesture = [](MouseButton button, PointerTarget target) {
        PointerGesture pointer;
        pointer.press(button, target, {10, 10}, 0.0);
        return pointer.gesture();
    };
    EXPECT_EQ(gesture(MouseButton::left, PointerTarget::nothing), Gesture::orbit);
    EXPECT_EQ(gesture(MouseButton::left, PointerTarget::cloth), Gesture::grab_cloth);
    EXPECT_EQ(gesture(MouseButton::left, PointerTarget::pin), Gesture::drag_pin);
    EXPECT_EQ(gesture(MouseButton::left, PointerTarget::obstacle), Gesture::move_obstacle);
    for (const auto target : {PointerTarget::nothing, PointerTarget::cloth, PointerTarget::pin,
                              PointerTarget::obstacle}) {
        EXPECT_EQ(gesture(MouseButton::middle, target), Gesture::pan);
        EXPECT_EQ(gesture(MouseButton::right, target), Gesture::pan);
    }
}

/// Presses at (100, 100), moves to `way` beyond and back to `back` beyond, releases.
bool is_click(PointerTarget target, float way, float back, double seconds,
              MouseButton button = MouseButton::left) {
    PointerGesture pointer;
    pointer.press(button, target, {100, 100}, 5.0);
    pointer.move({100 + way, 100});
    return pointer.release(button, {100 + back, 100}, 5.0 + seconds);
}

TEST(PointerGesture, AShortStillPressIsAClick) {
    EXPECT_TRUE(is_click(PointerTarget::cloth, 0, 0, 0.1));
    EXPECT_TRUE(is_click(PointerTarget::pin, 4, 3, 0.39));
}

TEST(PointerGesture, ADragIsNoClick) {
    EXPECT_FALSE(is_click(PointerTarget::cloth, 5, 5, 0.1));
    EXPECT_FALSE(is_click(PointerTarget::cloth, 0, 5, 0.1));
    EXPECT_FALSE(is_click(PointerTarget::cloth, 40, 0, 0.1));  // there and back
}

TEST(PointerGesture, ALongPressIsNoClick) {
    EXPECT_FALSE(is_click(PointerTarget::cloth, 0, 0, 0.41));
}

TEST(PointerGesture, OnlyClothAndPinsTakeClicksOfTheLeftButton) {
    EXPECT_FALSE(is_click(PointerTarget::nothing, 0, 0, 0.1));
    EXPECT_FALSE(is_click(PointerTarget::obstacle, 0, 0, 0.1));
    EXPECT_FALSE(is_click(PointerTarget::cloth, 0, 0, 0.1, MouseButton::right));
}

TEST(PointerGesture, MovementsAddUpToTheWholeWay) {
    PointerGesture pointer;
    pointer.press(MouseButton::left, PointerTarget::nothing, {10, 20}, 0.0);
    EXPECT_EQ(pointer.move({13, 18}), glm::vec2(3, -2));
    EXPECT_EQ(pointer.move({13, 18}), glm::vec2(0, 0));
    EXPECT_EQ(pointer.move({10, 20}), glm::vec2(-3, 2));
}

TEST(PointerGesture, TheFirstButtonHasItUntilItIsReleased) {
    PointerGesture pointer;
    pointer.press(MouseButton::left, PointerTarget::cloth, {10, 10}, 0.0);
    pointer.press(MouseButton::right, PointerTarget::nothing, {50, 50}, 0.1);
    EXPECT_EQ(pointer.gesture(), Gesture::grab_cloth);
    EXPECT_FALSE(pointer.release(MouseButton::right, {10, 10}, 0.15));
    EXPECT_EQ(pointer.gesture(), Gesture::grab_cloth);
    EXPECT_TRUE(pointer.release(MouseButton::left, {10, 10}, 0.2));
    EXPECT_EQ(pointer.gesture(), Gesture::none);
}

TEST(PointerGesture, CancelledItIsNoClick) {
    PointerGesture pointer;
    pointer.press(MouseButton::left, PointerTarget::cloth, {10, 10}, 0.0);
    pointer.cancel();
    EXPECT_EQ(pointer.gesture(), Gesture::none);
    EXPECT_FALSE(pointer.release(MouseButton::left, {10, 10}, 0.1));
}

}  // namespace
}  // namespace weft::viewer
