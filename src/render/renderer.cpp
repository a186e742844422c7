// The passes of a picture: shadow map, cloth and mast, ground, sky.
#include "render/renderer.h"

#include <cstddef>
#include <string>

#include "render/mast.h"
#include "render/shader_program.h"
#include "render/shaders.h"

namespace weft {

namespace {

/// The uniform block Scene of scene.glsl (std140: every member fills whole vec4s).
struct SceneBlock {
    glm::mat4 to_clip, to_shadow;
    glm::vec4 eye, to_sun, ground, shadow, mast;
};

// How soft shadows are: half the width of the edge that the taps blur. The sun's disc makes an edge
// grow with the distance from caster to ground; a share of the cloth's size stands for it.
constexpr float ground_softness = 0.0085F;  // of the cloth's size
constexpr float cloth_spacing = 1.4F;       // [texels]
constexpr float ground_taps = 6.0F;         // a side, as in ground.frag

GlProgram make_drawing_program(std::string_view vertex, std::string_view fragment) {
    const std::string lit_fragment = std::string(shaders::light) + std::string(fragment);
    return make_program(shaders::scene, vertex, lit_fragment);
}

}  // namespace

Renderer::Renderer(const Surface& surface, const RenderDescription& render)
    : cloth_(surface, render.texture),
      cloth_program_(make_drawing_program(shaders::mesh_vertex, shaders::cloth_fragment)),
      solid_program_(make_drawing_program(shaders::mesh_vertex, shaders::solid_fragment)),
      ground_program_(make_drawing_program(shaders::ground_vertex, shaders::ground_fragment)),
      sky_program_(make_drawing_program(shaders::sky_vertex, shaders::sky_fragment)),
      shadow_program_(
          make_program(shaders::scene, shaders::shadow_vertex, shaders::shadow_fragment)) {}

void Renderer::set_stage(const Stage& stage) {
    stage_ = stage;
    solid_index_count_ = 0;
    if (!stage.mast) return;
    const Solid solid = build_mast(*stage.mast);
    solid_index_count_ = static_cast<GLsizei>(solid.indices.size());
    glBindVertexArray(solid_array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, solid_vertices_.name());
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(solid.vertices.size() * sizeof(SolidVertex)),
                 solid.vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, solid_indices_.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(solid.indices.size() * sizeof(std::uint32_t)),
                 solid.indices.data(), GL_STATIC_DRAW);
    const auto attribute = [](GLuint location, std::size_t offset) {
        // OpenGL wants the offset into the buffer as a pointer.
        glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(SolidVertex),
                              reinterpret_cast<const void*>(offset));
        glEnableVertexAttribArray(location);
    };
    attribute(position_attribute, offsetof(SolidVertex, position));
    attribute(normal_attribute, offsetof(SolidVertex, normal));
    attribute(colour_attribute, offsetof(SolidVertex, colour));
    glBindVertexArray(0);
}

void Renderer::update_scene_block(const Camera& camera, const DrawTarget& target,
                                  const Box& cloth) const {
    // The map covers what casts shadows now, not all that ever may: finer, and less of the ground
    // has to ask it.
    Box casters = cloth;
    if (stage_.mast) casters = casters.grown_to(stage_.mast->foot).grown_to(stage_.mast->top);
    const ShadowView sun = sun_view(casters, stage_.to_sun, stage_.ground);
    const float aspect = static_cast<float>(target.width) / static_cast<float>(target.height);
    const glm::vec3 below{stage_.rest.middle().x, stage_.ground.value_or(0.0F),
                          stage_.rest.middle().z};
    const float ground_spacing =
        2.0F * ground_softness * stage_.size / ((ground_taps - 1.0F) * sun.texel);
    SceneBlock block{};
    block.to_clip = camera.world_to_clip(aspect);
    block.to_shadow = sun.world_to_map;
    block.eye = glm::vec4(camera.eye, 1.0F);
    block.to_sun = glm::vec4(stage_.to_sun, 0.0F);
    block.ground = glm::vec4(below, stage_.size);
    block.shadow = {1.0F / static_cast<float>(ShadowMap::resolution), sun.texel, cloth_spacing,
                    ground_spacing};
    if (stage_.mast && !stage_.mast->level)
        block.mast = glm::vec4(stage_.mast->foot, stage_.mast->radius);
    glBindBuffer(GL_UNIFORM_BUFFER, scene_buffer_.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(block), &block, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, scene_block_binding, scene_buffer_.name());
}

void Renderer::cast_shadows() const {
    shadow_map_.begin();
    glUseProgram(shadow_program_.name());
    glEnable(GL_POLYGON_OFFSET_FILL);  // keeps a slope from shadowing itself by rounding
    glPolygonOffset(1.5F, 2.0F);
    cloth_.draw();
    glBindVertexArray(solid_array_.name());
    glDrawElements(GL_TRIANGLES, solid_index_count_, GL_UNSIGNED_INT, nullptr);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void Renderer::draw_scene(const DrawTarget& target) const {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, target.width, target.height);
    glClear(GL_DEPTH_BUFFER_BIT);  // the sky covers what is left of the colours
    shadow_map_.bind_texture();
    glUseProgram(cloth_program_.name());
    cloth_.draw();
    glUseProgram(solid_program_.name());
    glBindVertexArray(solid_array_.name());
    glDrawElements(GL_TRIANGLES, solid_index_count_, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(no_array_.name());
    if (stage_.ground) {
        glUseProgram(ground_program_.name());
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    glUseProgram(sky_program_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

void Renderer::draw(const Frame& frame, const Camera& camera, const DrawTarget& target) {
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_MULTISAMPLE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    const Box cloth = cloth_.update(frame);
    update_scene_block(camera, target, cloth);
    cast_shadows();
    draw_scene(target);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace weft
