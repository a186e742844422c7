// A camera that a mouse turns around a point.
#pragma once

#include "render/camera.h"

namespace weft::viewer {

/// y is up; the camera never turns over the poles. Every movement keeps the near and far planes
/// around what is to be seen.
class OrbitCamera {
public:
    /// @param start as of choose_camera(); where it looks straight down, it is tilted by 3 degrees.
    explicit OrbitCamera(const Camera& start);

    /// A full turn for a drag over 2 picture heights.  @param pixels of the drag, y downward.
    void orbit(glm::vec2 pixels, float picture_height);
    /// The point under the cursor in the target's depth follows it.
    void pan(glm::vec2 pixels, float picture_height);
    /// Nearer by a tenth a notch. The point under the cursor stays where it is.
    /// @param cursor from -1 to 1, x rightward, y upward.  @param aspect width over height.
    void zoom(float notches, glm::vec2 cursor, float aspect);
    /// Shows all of a box from the present direction.
    void frame(const Box& box, float aspect);

    [[nodiscard]] const Camera& camera() const { return camera_; }

private:
    void place();
    Camera camera_;
    float yaw_ = 0.0F, pitch_ = 0.0F;  ///< of the eye around the target [rad]
    float distance_ = 1.0F;            ///< [m]
    float size_ = 1.0F;                ///< of what is shown, its box's diagonal [m]
};

}  // namespace weft::viewer
