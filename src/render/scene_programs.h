// The shader programs that a scene is drawn with.
#pragma once

#include <optional>

#include "render/gl_object.h"

namespace weft {

/// How much work a picture may take.
enum class Effort {
    full,   ///< recordings, and windows with a graphics processor: light and soft shadow per pixel
    quick,  ///< windows whose driver draws on the processor: most of it per corner
};

/// The ground in parts, so that only what may lie in a shadow asks for it.
struct QuickGroundPrograms {
    GlProgram under_map;  ///< the part that the shadow map covers
    GlProgram contact;    ///< less sky around bodies: multiplied with what is there
};

struct ScenePrograms {
    GlProgram cloth, mast, obstacle, ground, sky;
    std::optional<QuickGroundPrograms> quick_ground;  ///< of Effort::quick; `ground` is the rest
};

/// @throws Error (file) where the driver refuses.
ScenePrograms make_scene_programs(Effort effort);

/// Corners that the quick programs make of nothing: see quick_ground.vert, quick_contact.vert and
/// quick_sky.vert.
inline constexpr GLsizei quick_ground_corners = 6 * 40 * 18;
inline constexpr GLsizei quick_under_map_corners = 6 * 12 * 12;
inline constexpr GLsizei quick_contact_corners = 6 * 9;
inline constexpr GLsizei quick_sky_corners = 6 * 24 * 32;

}  // namespace weft
