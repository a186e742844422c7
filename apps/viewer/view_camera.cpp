// When the camera follows the scene, and when the mouse.
#include "viewer/view_camera.h"

#include <algorithm>

namespace weft::viewer {

Camera camera_for(const Stage& stage, RenderDescription render, const ViewArea& area) {
    const float wanted =
        static_cast<float>(render.size[0]) / static_cast<float>(std::max(render.size[1], 1));
    render.size = {area.width, area.height};
    Camera camera = choose_camera(stage, render);
    // An eye that the scene fixes saw what it should in pictures of the wanted proportions.
    if (render.camera && area.aspect() < wanted)
        camera.eye = camera.target + wanted / area.aspect() * (camera.eye - camera.target);
    return camera;
}

bool elsewhere(const Box& one, const Box& other) {
    const float size = glm::distance(one.low, one.high);
    const float other_size = glm::distance(other.low, other.high);
    const float larger = std::max(size, other_size);
    return larger > 1.5F * std::min(size, other_size) ||
           glm::distance(one.middle(), other.middle()) > 0.5F * larger;
}

void ViewCamera::begin(const Stage& stage, const RenderDescription& render, const ViewArea& area) {
    orbit_.emplace(camera_for(stage, render, area));
    rest_ = stage.rest;
    kept_ = false;
}

void ViewCamera::follow(const Stage& stage, const RenderDescription& render, const ViewArea& area,
                        const std::function<Box()>& cloth) {
    const bool same_place = orbit_ && stage.rest.low == rest_.low && stage.rest.high == rest_.high;
    const bool same_area = area.width == area_.width && area.height == area_.height;
    // Narrower by half: cloths came beside this one, and would be cut off at the sides.
    const bool squeezed = orbit_ && !area_.empty() && area.aspect() < 0.75F * area_.aspect();
    if (!orbit_ || elsewhere(stage.rest, rest_) || (!kept_ && !(same_place && same_area)))
        begin(stage, render, area);
    else if (framing_ || squeezed)
        orbit_->frame(cloth(), area.aspect());
    kept_ = kept_ || framing_;
    framing_ = false;
    area_ = area;
}

}  // namespace weft::viewer
