// Shader programs from the GLSL files in render/shaders, which are built into the library.
#pragma once

#include <string_view>

#include "render/gl_object.h"

namespace weft {

/// Binding points that all programs share.
inline constexpr GLuint scene_block_binding = 0;
inline constexpr GLint cloth_texture_unit = 0;
inline constexpr GLint shadow_texture_unit = 1;
inline constexpr GLint line_texture_unit = 2;

/// Attribute locations that all vertex shaders share.
inline constexpr GLuint position_attribute = 0;  ///< vec3 [m]
inline constexpr GLuint normal_attribute = 1;    ///< vec3
inline constexpr GLuint colour_attribute = 2;    ///< vec3: a linear colour, or u, v and nothing

/// Compiles and links a program and connects its scene block and textures. `common` goes before
/// each of the two shaders.
/// @throws Error (file) with the driver's words where it does not compile.
GlProgram make_program(std::string_view common, std::string_view vertex, std::string_view fragment);

}  // namespace weft
