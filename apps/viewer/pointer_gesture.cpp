#include "viewer/pointer_gesture.h"

#include <algorithm>

namespace weft::viewer {

namespace {

constexpr float click_pixels = 4.0F;
constexpr double click_seconds = 0.4;

Gesture gesture_of(MouseButton button, PointerTarget target) {
    if (button != MouseButton::left) return Gesture::pan;
    switch (target) {
        case PointerTarget::cloth:
            return Gesture::grab_cloth;
        case PointerTarget::pin:
            return Gesture::drag_pin;
        case PointerTarget::obstacle:
            return Gesture::move_obstacle;
        case PointerTarget::nothing:
            break;
    }
    return Gesture::orbit;
}

}  // namespace

void PointerGesture::press(MouseButton button, PointerTarget target, glm::vec2 pixels,
                           double time) {
    if (gesture_ != Gesture::none) return;  // the first button has it until it is released
    gesture_ = gesture_of(button, target);
    button_ = button;
    target_ = target;
    start_ = last_ = pixels;
    travelled_ = 0.0F;
    start_time_ = time;
}

glm::vec2 PointerGesture::move(glm::vec2 pixels) {
    const glm::vec2 moved = pixels - last_;
    last_ = pixels;
    travelled_ = std::max(travelled_, glm::distance(pixels, start_));
    return moved;
}

bool PointerGesture::is_drag(double time) const {
    return travelled_ > click_pixels || time - start_time_ > click_seconds;
}

bool PointerGesture::release(MouseButton button, glm::vec2 pixels, double time) {
    if (gesture_ == Gesture::none || button != button_) return false;
    move(pixels);
    gesture_ = Gesture::none;
    const bool clickable = target_ == PointerTarget::cloth || target_ == PointerTarget::pin;
    return button == MouseButton::left && clickable && !is_drag(time);
}

}  // namespace weft::viewer
