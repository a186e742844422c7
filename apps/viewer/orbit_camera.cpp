#include "viewer/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace weft::viewer {

namespace {

// Camera turns its picture where it looks straight down; no steeper than this, it does not.
constexpr float steepest = 1.518F;  // [rad]: 87 degrees

constexpr float near_part = 0.02F;   // of the size, as choose_camera has it
constexpr float far_parts = 200.0F;  // likewise
constexpr float closest_part = 0.005F, farthest_parts = 100.0F;
constexpr float filled = 0.9F;  // of the picture's tighter side, by frame()

struct Axes {
    glm::vec3 right, up, forward;
};

Axes axes_of(float yaw, float pitch) {
    const glm::vec3 right(std::cos(yaw), 0.0F, -std::sin(yaw));
    const glm::vec3 forward(-std::cos(pitch) * std::sin(yaw), -std::sin(pitch),
                            -std::cos(pitch) * std::cos(yaw));
    return {right, glm::cross(right, forward), forward};
}

float half_tangent(const Camera& camera) {
    return std::tan(0.5F * glm::radians(camera.field_of_view));
}

/// One axis of the picture. An eye at e sees all points p where
/// |p_axis - e_axis| <= tangent (p_forward - e_forward).
struct Extent {
    float tangent;
    float above = -std::numeric_limits<float>::infinity();
    float below = -std::numeric_limits<float>::infinity();

    void add(float along_axis, float along_forward) {
        above = std::max(above, along_axis - tangent * along_forward);
        below = std::max(below, -along_axis - tangent * along_forward);
    }
    [[nodiscard]] float middle() const { return 0.5F * (above - below); }
    [[nodiscard]] float eye_forward() const { return -0.5F * (above + below) / tangent; }
};

}  // namespace

OrbitCamera::OrbitCamera(const Camera& start)
    : camera_(start), size_(start.near_plane / near_part) {
    const glm::vec3 toward_eye = start.eye - start.target;
    distance_ = std::max(glm::length(toward_eye), closest_part * size_);
    yaw_ = std::atan2(toward_eye.x, toward_eye.z);
    pitch_ = std::asin(std::clamp(toward_eye.y / distance_, -1.0F, 1.0F));
    place();
}

void OrbitCamera::place() {
    pitch_ = std::clamp(pitch_, -steepest, steepest);
    yaw_ = std::remainder(yaw_, 2.0F * std::numbers::pi_v<float>);
    camera_.eye = camera_.target - distance_ * axes_of(yaw_, pitch_).forward;
    camera_.near_plane = near_part * std::min(size_, distance_);
    camera_.far_plane = far_parts * size_ + 2.0F * distance_;
}

void OrbitCamera::orbit(glm::vec2 pixels, float picture_height) {
    const glm::vec2 angle = std::numbers::pi_v<float> / picture_height * pixels;
    yaw_ -= angle.x;
    pitch_ += angle.y;
    place();
}

void OrbitCamera::pan(glm::vec2 pixels, float picture_height) {
    const Axes axes = axes_of(yaw_, pitch_);
    const float metres_per_pixel = 2.0F * half_tangent(camera_) * distance_ / picture_height;
    camera_.target += metres_per_pixel * (pixels.y * axes.up - pixels.x * axes.right);
    place();
}

void OrbitCamera::zoom(float notches, glm::vec2 cursor, float aspect) {
    const Axes axes = axes_of(yaw_, pitch_);
    const float before = distance_;
    distance_ = std::clamp(distance_ * std::pow(0.9F, notches), closest_part * size_,
                           farthest_parts * size_);
    camera_.target += (before - distance_) * half_tangent(camera_) *
                      (aspect * cursor.x * axes.right + cursor.y * axes.up);
    place();
}

void OrbitCamera::frame(const Box& box, float aspect) {
    const Axes axes = axes_of(yaw_, pitch_);
    const float tangent = filled * half_tangent(camera_);
    Extent across{aspect * tangent}, upward{tangent};
    for (const glm::vec3& corner : box.corners()) {
        const float depth = glm::dot(corner, axes.forward);
        across.add(glm::dot(corner, axes.right), depth);
        upward.add(glm::dot(corner, axes.up), depth);
    }
    const float extent = glm::distance(box.low, box.high);
    if (extent > 0.0F) size_ = extent;
    const float depth = glm::dot(box.middle(), axes.forward);
    distance_ = std::max(depth - std::min(across.eye_forward(), upward.eye_forward()),
                         closest_part * size_);
    camera_.target =
        across.middle() * axes.right + upward.middle() * axes.up + depth * axes.forward;
    place();
}

}  // namespace weft::viewer
