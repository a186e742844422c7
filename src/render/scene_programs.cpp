// Putting the scene's programs together from their texts.
#include "render/scene_programs.h"

#include <string>

#include "render/shader_program.h"
#include "render/shaders.h"

namespace weft {

namespace {

template <typename... Texts>
std::string joined(Texts... texts) {
    std::string all;
    (all.append(texts), ...);
    return all;
}

GlProgram full(std::string_view vertex, std::string_view before, std::string_view fragment) {
    return make_program(shaders::scene, vertex,
                        joined(shaders::light, shaders::dither, shaders::pixel, before, fragment));
}

GlProgram quick(std::string_view vertex, std::string_view before, std::string_view fragment) {
    return make_program(shaders::scene, joined(shaders::light, vertex),
                        joined(shaders::light, shaders::dither, shaders::quick, before, fragment));
}

/// A quick program with a constant for its vertex shader.
GlProgram with_constant(GlProgram program, const char* name, int value) {
    glUseProgram(program.name());
    glUniform1i(glGetUniformLocation(program.name(), name), value);
    glUseProgram(0);
    return program;
}

GlProgram quick_solid(bool matt) {
    return with_constant(quick(shaders::quick_solid_vertex, "", shaders::quick_solid_fragment),
                         "matt", matt ? 1 : 0);
}

GlProgram quick_ground(bool under_map) {
    const auto fragment =
        under_map ? shaders::quick_shadow_fragment : shaders::quick_ground_fragment;
    return with_constant(quick(shaders::quick_ground_vertex, "", fragment), "under_map",
                         under_map ? 1 : 0);
}

}  // namespace

ScenePrograms make_scene_programs(Effort effort) {
    if (effort == Effort::full) {
        return {full(shaders::mesh_vertex, "", shaders::cloth_fragment),
                full(shaders::mesh_vertex, "", shaders::solid_fragment),
                full(shaders::mesh_vertex, "", shaders::obstacle_fragment),
                full(shaders::ground_vertex, shaders::open_sky, shaders::ground_fragment),
                full(shaders::sky_vertex, "", shaders::sky_fragment),
                std::nullopt};
    }
    return {quick(shaders::quick_cloth_vertex, "", shaders::quick_cloth_fragment),
            quick_solid(false),
            quick_solid(true),
            quick_ground(false),
            quick(shaders::quick_sky_vertex, "", shaders::quick_sky_fragment),
            QuickGroundPrograms{quick_ground(true),
                                quick(shaders::quick_contact_vertex, shaders::open_sky,
                                      shaders::quick_contact_fragment)}};
}

}  // namespace weft
