// The text of the GLSL files in render/shaders; the build writes shaders.cpp from them.
#pragma once

#include <string_view>

namespace weft::shaders {

extern const std::string_view scene;            ///< scene.glsl: uniforms; before every shader
extern const std::string_view light;            ///< light.glsl: before every lit fragment shader
extern const std::string_view mesh_vertex;      ///< mesh.vert
extern const std::string_view cloth_fragment;   ///< cloth.frag
extern const std::string_view solid_fragment;   ///< solid.frag
extern const std::string_view ground_vertex;    ///< ground.vert
extern const std::string_view ground_fragment;  ///< ground.frag
extern const std::string_view sky_vertex;       ///< sky.vert
extern const std::string_view sky_fragment;     ///< sky.frag
extern const std::string_view shadow_vertex;    ///< shadow.vert
extern const std::string_view shadow_fragment;  ///< shadow.frag

}  // namespace weft::shaders
