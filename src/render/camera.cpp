// Choosing a camera that frames the whole motion.
#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "weft/error.h"

namespace weft {

namespace {

constexpr float margin = 0.05F;  // of the picture's half side, kept free on each side

/// The axes of a camera that looks along `forward`.
struct Axes {
    glm::vec3 right, up, forward;
};

Axes axes_along(glm::vec3 forward) {
    // Looking straight up or down, "up" in the picture is -z, as on a map.
    const glm::vec3 up = std::abs(forward.y) > 0.999F ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    const glm::vec3 right = glm::normalize(glm::cross(forward, up));
    return {right, glm::cross(right, forward), forward};
}

/// For one axis of the picture: all points p are in view of an eye e when
/// |p_axis - e_axis| <= tangent (p_forward - e_forward).
struct Fit {
    float above = -std::numeric_limits<float>::infinity();  // greatest  p_axis - tangent p_forward
    float below = -std::numeric_limits<float>::infinity();  // greatest -p_axis - tangent p_forward
    float tangent = 1.0F;

    void add(float along_axis, float along_forward) {
        above = std::max(above, along_axis - tangent * along_forward);
        below = std::max(below, -along_axis - tangent * along_forward);
    }
    [[nodiscard]] float middle() const { return 0.5F * (above - below); }
    /// The greatest e_forward with everything in view, where e_axis is `axis`.
    [[nodiscard]] float nearest(float axis) const {
        return -std::max(above - axis, below + axis) / tangent;
    }
};

/// Places the eye on the ray through `target`, or where the points fill the picture best.
Camera fit_view(const Stage& stage, const RenderDescription& render, glm::vec3 forward) {
    const Axes axes = axes_along(forward);
    const auto angle = static_cast<float>(glm::radians(render.field_of_view));
    const auto aspect = static_cast<float>(render.size[0]) / static_cast<float>(render.size[1]);
    Fit across, upward;
    upward.tangent = (1.0F - margin) * std::tan(0.5F * angle);
    across.tangent = aspect * upward.tangent;
    for (const glm::vec3& point : stage.view) {
        across.add(glm::dot(point, axes.right), glm::dot(point, forward));
        upward.add(glm::dot(point, axes.up), glm::dot(point, forward));
    }
    const float x = render.target ? glm::dot(to_glm(*render.target), axes.right) : across.middle();
    const float y = render.target ? glm::dot(to_glm(*render.target), axes.up) : upward.middle();
    const float z = std::min(across.nearest(x), upward.nearest(y));
    Camera camera;
    camera.eye = x * axes.right + y * axes.up + z * forward;
    const glm::vec3 looked_at = render.target ? to_glm(*render.target) : stage.rest.middle();
    const float distance = std::max(glm::dot(looked_at - camera.eye, forward), 0.1F * stage.size);
    camera.target = camera.eye + distance * forward;
    return camera;
}

/// From the front, turned to the left and a little from above: enough to see depth.
glm::vec3 automatic_direction(const Stage& stage) {
    const float turn = glm::radians(stage.lying ? 32.0F : 20.0F);
    const float rise = glm::radians(stage.lying ? 20.0F : 7.0F);
    const glm::vec3 side = glm::cross(glm::vec3(0, 1, 0), stage.front);
    const glm::vec3 level = std::cos(turn) * stage.front - std::sin(turn) * side;
    return -(std::cos(rise) * level + std::sin(rise) * glm::vec3(0, 1, 0));
}

}  // namespace

glm::mat4 Camera::world_to_clip(float aspect) const {
    const Axes axes = axes_along(glm::normalize(target - eye));
    return glm::perspective(glm::radians(field_of_view), aspect, near_plane, far_plane) *
           glm::lookAt(eye, target, axes.up);
}

Camera choose_camera(const Stage& stage, const RenderDescription& render) {
    Camera camera;
    if (render.camera) {
        camera.eye = to_glm(*render.camera);
        camera.target = render.target ? to_glm(*render.target) : stage.rest.middle();
        if (glm::distance(camera.eye, camera.target) <= 1e-6F * stage.size) {
            throw scene_error("render.camera", "the point that the camera looks at",
                              "a point away from render.target");
        }
    } else {
        camera = fit_view(stage, render, automatic_direction(stage));
    }
    camera.field_of_view = static_cast<float>(render.field_of_view);
    camera.near_plane = 0.02F * stage.size;
    camera.far_plane = 200.0F * stage.size + 2.0F * glm::distance(camera.eye, camera.target);
    return camera;
}

}  // namespace weft
