// Marks of what the mouse would take hold of, and of what it holds.
#pragma once

#include "viewer/canvas.h"
#include "viewer/touch_target.h"

namespace weft::viewer {

/// Rings a pin or a particle, the outline of a sphere, the handle of a plane.
void draw_target(const Canvas& canvas, const ViewArea& area, const Camera& camera,
                 const Shown& shown, const TouchTarget& target);

/// The line from the cloth to the hand, with the force beside it.
void draw_hold(const Canvas& canvas, const ViewArea& area, const Camera& camera, glm::vec3 particle,
               glm::vec3 hand, double newtons);

/// The cursor that goes with a target.
ImGuiMouseCursor cursor_of(const TouchTarget& target);

}  // namespace weft::viewer
