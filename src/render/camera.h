// Where a picture is taken from.
#pragma once

#include <glm/glm.hpp>

#include "render/stage.h"

namespace weft {

struct Camera {
    glm::vec3 eye{0, 0, 1};     ///< [m]
    glm::vec3 target{0, 0, 0};  ///< point looked at [m]
    float field_of_view = 35;   ///< vertical [degrees]
    float near_plane = 0.1F;    ///< distances [m]
    float far_plane = 100.0F;

    /// From the world to OpenGL's clip space. @param aspect width over height of the picture.
    [[nodiscard]] glm::mat4 world_to_clip(float aspect) const;
};

/// The camera of a recording: at render.camera looking at render.target where these are given, else
/// a three-quarter view from the front that shows all of stage.view.
/// @throws Error (usage) where camera and target are one point.
Camera choose_camera(const Stage& stage, const RenderDescription& render);

}  // namespace weft
