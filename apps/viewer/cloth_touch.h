// From the mouse over shown cloths to grips, pins, obstacles and the camera. Knows no window.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "viewer/grip_patch.h"
#include "viewer/orbit_camera.h"
#include "viewer/touch_target.h"

namespace weft::viewer {

/// What the mouse asks for.
struct TouchRequests {
    std::function<void(std::size_t cloth, std::vector<Grip> grips)> grip;  ///< empty: lets go
    std::function<void(std::size_t particle, Vec3d present_position)> toggle_pin;
    std::function<void(std::size_t particle, Vec3d shift)> move_pin;  ///< since the last call
    std::function<void(std::size_t obstacle, Vec3d shift)> move_obstacle;
    std::function<void()> gesture_ended;
};

/// The mouse in one frame of the window.
struct Pointer {
    struct Button {
        bool pressed = false, released = false;  ///< since the last frame
        bool down = false;
    };
    glm::vec2 pixel{-1.0F};         ///< of the framebuffer, from its upper left corner
    std::array<Button, 3> buttons;  ///< in the order of MouseButton
    float wheel = 0.0F;             ///< notches, positive away from the hand
    bool free = true;               ///< false: over a panel, which has it
    double time = 0.0;              ///< [s]
    float scale = 1.0F;             ///< pixels a screen unit: a click may stray by 4 of those
};

/// The cloth that the hand holds.
struct Hold {
    std::size_t cloth = 0;
    std::size_t particle = 0;
    glm::dvec3 hand{0.0};  ///< [m]
};

class ClothTouch {
public:
    explicit ClothTouch(TouchRequests requests) : requests_(std::move(requests)) {}

    /// Obeys one frame's mouse. @param areas of shown.cloths.
    void update(const Pointer& pointer, const Shown& shown, std::span<const ViewArea> areas,
                OrbitCamera& camera);
    /// Lets go; what was dragged goes back to where it was taken.
    void cancel();

    /// What a press would take hold of, or what is held.
    [[nodiscard]] const TouchTarget& target() const { return target_; }
    [[nodiscard]] Gesture gesture() const { return gesture_.gesture(); }
    [[nodiscard]] const std::optional<Hold>& hold() const { return hold_; }
    /// Whether the mouse has turned, panned or zoomed the camera.
    [[nodiscard]] bool moved_camera() const { return moved_camera_; }
    void forget_camera_moves() { moved_camera_ = false; }

private:
    void begin(const Pointer& pointer, std::size_t button, const ShownCloth& cloth);
    void look(const Pointer& pointer, const Shown& shown, const CursorPlace& place,
              const Camera& camera);
    void go_on(const Pointer& pointer, const Shown& shown, std::span<const ViewArea> areas,
               OrbitCamera& camera);
    void drag(const CursorPlace& place, const Shown& shown, glm::vec2 moved, double time,
              OrbitCamera& camera);
    void drag_thing(const Ray& ray, const Shown& shown, const Camera& camera);
    void shift_thing(glm::dvec3 shift);
    void end(bool click, const Shown& shown);
    void let_go();
    [[nodiscard]] bool still_there(const Shown& shown) const;

    TouchRequests requests_;
    PointerGesture gesture_;
    TouchTarget target_;
    std::size_t button_ = 0;          ///< that began the gesture
    std::size_t particles_ = 0;       ///< of the cloth then
    glm::dvec3 shifted_{0.0};         ///< what is dragged has been moved by so much [m]
    std::optional<GripPatch> patch_;  ///< as it was under the hand when that closed
    std::optional<Hold> hold_;
    bool moved_camera_ = false;
    glm::vec2 looked_at_{-1.0F};  ///< where target_ was last sought [pixels]
    double looked_time_ = 0.0;    ///< when [s]
};

}  // namespace weft::viewer
