// The picture that the sun sees: how far its light reaches.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "render/gl_object.h"
#include "render/stage.h"

namespace weft {

/// A square depth picture along parallel rays of light.
class ShadowMap {
public:
    /// @param resolution of a side [texels].
    explicit ShadowMap(int resolution);

    [[nodiscard]] int resolution() const { return resolution_; }
    /// Binds and clears the map; what is drawn then casts shadows. Changes the viewport.
    void begin() const;
    /// Makes the map readable in shadow_texture_unit.
    void bind_texture() const;

private:
    int resolution_;
    GlTexture texture_;
    GlFramebuffer framebuffer_;
};

/// Where the sun's picture is taken from.
struct ShadowView {
    glm::mat4 world_to_map{1.0F};  ///< x, y and depth in [0, 1]
    float texel = 0.0F;            ///< side of a texel [m]
};

/// The view along the sun's rays that holds all that casts shadows, and in depth the ground too.
/// @param resolution of the map [texels].
ShadowView sun_view(const Box& casters, glm::vec3 to_sun, std::optional<float> ground,
                    int resolution);

}  // namespace weft
