// The text of the GLSL files in render/shaders; the build writes shaders.cpp from them.
#pragma once

#include <string_view>

namespace weft::shaders {

extern const std::string_view scene;     ///< scene.glsl: uniforms; before every shader of a scene
extern const std::string_view light;     ///< light.glsl: light and sky; before every lit shader
extern const std::string_view dither;    ///< dither.glsl: before every lit fragment shader
extern const std::string_view pixel;     ///< pixel.glsl: shadow; before every full fragment shader
extern const std::string_view open_sky;  ///< open_sky.glsl: before the two of the ground
extern const std::string_view quick;     ///< quick.glsl: before every quick fragment shader
extern const std::string_view mesh_vertex;             ///< mesh.vert
extern const std::string_view cloth_fragment;          ///< cloth.frag
extern const std::string_view solid_fragment;          ///< solid.frag
extern const std::string_view obstacle_fragment;       ///< obstacle.frag
extern const std::string_view ground_vertex;           ///< ground.vert
extern const std::string_view ground_fragment;         ///< ground.frag
extern const std::string_view sky_vertex;              ///< sky.vert
extern const std::string_view sky_fragment;            ///< sky.frag
extern const std::string_view shadow_vertex;           ///< shadow.vert
extern const std::string_view shadow_fragment;         ///< shadow.frag
extern const std::string_view quick_cloth_vertex;      ///< quick_cloth.vert
extern const std::string_view quick_cloth_fragment;    ///< quick_cloth.frag
extern const std::string_view quick_solid_vertex;      ///< quick_solid.vert
extern const std::string_view quick_solid_fragment;    ///< quick_solid.frag
extern const std::string_view quick_ground_vertex;     ///< quick_ground.vert
extern const std::string_view quick_ground_fragment;   ///< quick_ground.frag
extern const std::string_view quick_shadow_fragment;   ///< quick_shadow.frag
extern const std::string_view quick_contact_vertex;    ///< quick_contact.vert
extern const std::string_view quick_contact_fragment;  ///< quick_contact.frag
extern const std::string_view quick_sky_vertex;        ///< quick_sky.vert
extern const std::string_view quick_sky_fragment;      ///< quick_sky.frag
extern const std::string_view mark;                    ///< mark.glsl: before the five below
extern const std::string_view line_vertex;             ///< line.vert
extern const std::string_view line_fragment;           ///< line.frag
extern const std::string_view mark_vertex;             ///< mark.vert
extern const std::string_view thin_line_fragment;      ///< thin_line.frag
extern const std::string_view point_fragment;          ///< point.frag

}  // namespace weft::shaders
