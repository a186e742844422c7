// From presses and movements of the mouse to what they mean. Knows no window.
#pragma once

#include <glm/glm.hpp>

namespace weft::viewer {

enum class MouseButton { left, middle, right };

/// What a drag does, decided when its button goes down.
enum class Gesture { none, grab_cloth, drag_pin, move_obstacle, orbit, pan };

/// What the press met; only read for the left button.
enum class PointerTarget { nothing, cloth, pin, obstacle };

/// Left drag on the cloth grabs, on a pin moves it, on an obstacle moves that, elsewhere orbits;
/// middle and right drag pan. A press and release of the left button within 4 pixels and 0.4 s on
/// the cloth or a pin is a click: it pins or unpins.
class PointerGesture {
public:
    void press(MouseButton button, PointerTarget target, glm::vec2 pixels, double time);
    /// @return how far the pointer moved since the last call [pixels].
    glm::vec2 move(glm::vec2 pixels);
    /// @return whether it was a click.
    bool release(MouseButton button, glm::vec2 pixels, double time);
    void cancel() { gesture_ = Gesture::none; }
    /// Whether it has gone on for too long or too far to be a click.
    [[nodiscard]] bool is_drag(double time) const;

    [[nodiscard]] Gesture gesture() const { return gesture_; }

private:
    Gesture gesture_ = Gesture::none;
    MouseButton button_ = MouseButton::left;
    PointerTarget target_ = PointerTarget::nothing;
    glm::vec2 start_{0.0F}, last_{0.0F};
    float travelled_ = 0.0F;  ///< farthest from start_ [pixels]
    double start_time_ = 0.0;
};

}  // namespace weft::viewer
