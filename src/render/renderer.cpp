// The passes of a picture: shadow map, cloth and solids, ground, sky.
#include "render/renderer.h"

#include <cstddef>
#include <variant>

#include "render/mast.h"
#include "render/obstacle_solids.h"
#include "render/shader_program.h"
#include "render/shaders.h"

namespace weft {

namespace {

constexpr std::size_t most_balls = 8;

/// The uniform block Scene of scene.glsl (std140: every member fills whole vec4s).
struct SceneBlock {
    glm::mat4 to_clip, to_shadow;
    glm::vec4 eye, to_sun, ground, shadow, mast;
    std::array<glm::vec4, most_balls> balls;
    glm::vec4 counts;
};

// How soft shadows are: half the width of the edge that the taps blur. The sun's disc makes an edge
// grow with the distance from caster to ground; a share of the cloth's size stands for it.
constexpr float ground_softness = 0.0085F;  // of the cloth's size
constexpr float cloth_spacing = 1.4F;       // [texels]
constexpr float ground_taps = 6.0F;         // a side, as in ground.frag

// Texels a side of the shadow map, by effort.
constexpr std::array<int, 2> shadow_resolution{1536, 1024};

std::size_t index_of(Effort effort) {
    return effort == Effort::full ? 0 : 1;
}

void add_balls(const Stage& stage, SceneBlock& block) {
    std::size_t count = 0;
    for (const ObstacleDescription& obstacle : stage.obstacles) {
        const auto* sphere = std::get_if<SphereObstacle>(&obstacle.shape);
        if (sphere == nullptr || count == most_balls) continue;
        block.balls[count++] =
            glm::vec4(to_glm(sphere->centre), static_cast<float>(sphere->radius));
    }
    block.counts.x = static_cast<float>(count);
}

}  // namespace

struct Renderer::Passes {
    const ScenePrograms& programs;
    const ShadowMap& shadow_map;
    std::optional<float> floor;  ///< height [m]
    bool shadowed = true;        ///< something casts a shadow
};

Renderer::Renderer(const Surface& surface, const RenderDescription& render)
    : cloth_(surface, render.texture),
      shadow_program_(
          make_program(shaders::scene, shaders::shadow_vertex, shaders::shadow_fragment)) {}

void Renderer::set_stage(const Stage& stage) {
    stage_ = stage;
    solids_built_.reset();
    shadow_cast_.reset();
}

void Renderer::build_solids(Effort effort) {
    if (solids_built_ == effort) return;
    const bool fine = effort == Effort::full;
    mast_.set(stage_.mast ? build_mast(*stage_.mast, fine) : Solid{});
    const Solid obstacles = build_obstacles(stage_, fine);
    obstacles_.set(obstacles);
    obstacle_bounds_ = bounds_of(obstacles);
    solids_built_ = effort;
    shadow_cast_.reset();
}

Renderer::Passes Renderer::passes_for(const DrawOptions& options) {
    const std::size_t i = index_of(options.effort);
    if (!programs_[i]) programs_[i].emplace(make_scene_programs(options.effort));
    if (!shadow_maps_[i]) shadow_maps_[i].emplace(shadow_resolution[i]);
    build_solids(options.effort);
    return {*programs_[i], *shadow_maps_[i], floor_height(stage_), false};
}

/// The map covers what casts shadows now, not all that ever may: finer, and less of the ground has
/// to ask it.
std::optional<Box> Renderer::casters(const DrawOptions& options) const {
    if (!options.shadow) return std::nullopt;
    std::optional<Box> box;
    const auto grow = [&](glm::vec3 low, glm::vec3 high) {
        box = box ? box->grown_to(low).grown_to(high) : Box{low, low}.grown_to(high);
    };
    if (options.cloth) grow(cloth_.bounds().low, cloth_.bounds().high);
    if (stage_.mast) grow(stage_.mast->foot, stage_.mast->top);
    if (obstacle_bounds_) grow(obstacle_bounds_->low, obstacle_bounds_->high);
    return box;
}

void Renderer::update_scene_block(const Camera& camera, const DrawTarget& target,
                                  const Passes& passes, const std::optional<Box>& casters) const {
    // Without casters all places lie outside of the map, so that nobody reads it.
    const int resolution = passes.shadow_map.resolution();
    const ShadowView sun = casters ? sun_view(*casters, stage_.to_sun, passes.floor, resolution)
                                   : ShadowView{glm::mat4(0.0F), 0.001F * stage_.size};
    const float aspect = static_cast<float>(target.width) / static_cast<float>(target.height);
    const glm::vec3 below{stage_.rest.middle().x, passes.floor.value_or(0.0F),
                          stage_.rest.middle().z};
    const float ground_spacing =
        2.0F * ground_softness * stage_.size / ((ground_taps - 1.0F) * sun.texel);
    SceneBlock block{};
    block.to_clip = camera.world_to_clip(aspect);
    block.to_shadow = sun.world_to_map;
    block.eye = glm::vec4(camera.eye, 1.0F);
    block.to_sun = glm::vec4(stage_.to_sun, 0.0F);
    block.ground = glm::vec4(below, stage_.size);
    block.shadow = {1.0F / static_cast<float>(resolution), sun.texel, cloth_spacing,
                    ground_spacing};
    if (stage_.mast && !stage_.mast->level)
        block.mast = glm::vec4(stage_.mast->foot, stage_.mast->radius);
    if (casters) add_balls(stage_, block);
    glBindBuffer(GL_UNIFORM_BUFFER, scene_buffer_.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(block), &block, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, scene_block_binding, scene_buffer_.name());
}

void Renderer::cast_shadows(const Passes& passes, const DrawOptions& options) {
    passes.shadow_map.begin();
    glUseProgram(shadow_program_.name());
    glEnable(GL_POLYGON_OFFSET_FILL);  // keeps a slope from shadowing itself by rounding
    glPolygonOffset(1.5F, 2.0F);
    if (options.cloth) cloth_.draw(options.cloth_step, options.effort == Effort::quick);
    mast_.draw();
    obstacles_.draw();
    glDisable(GL_POLYGON_OFFSET_FILL);
    shadow_cast_ = options;
}

void Renderer::draw_ground(const Passes& passes) const {
    const auto& quick = passes.programs.quick_ground;
    if (!quick) {
        glUseProgram(passes.programs.ground.name());
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        return;
    }
    if (passes.shadowed) {
        glUseProgram(quick->under_map.name());
        glDrawArrays(GL_TRIANGLES, 0, quick_under_map_corners);
    }
    // Both lie in one plane: the rest is pushed behind the part that is drawn already.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0F, 32.0F);
    glUseProgram(passes.programs.ground.name());
    glDrawArrays(GL_TRIANGLES, 0, quick_ground_corners);
    glPolygonOffset(-2.0F, -64.0F);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glUseProgram(quick->contact.name());
    glDrawArrays(GL_TRIANGLES, 0, quick_contact_corners);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void Renderer::draw_surroundings(const Passes& passes) const {
    glBindVertexArray(no_array_.name());
    if (passes.floor) draw_ground(passes);
    glUseProgram(passes.programs.sky.name());
    glDrawArrays(GL_TRIANGLES, 0, passes.programs.quick_ground ? quick_sky_corners : 3);
    glBindVertexArray(0);
}

void Renderer::draw_scene(const DrawTarget& target, const Passes& passes,
                          const DrawOptions& options) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(target.left, target.bottom, target.width, target.height);
    glScissor(target.left, target.bottom, target.width, target.height);
    glEnable(GL_SCISSOR_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);  // the sky covers what is left of the colours
    passes.shadow_map.bind_texture();
    if (options.cloth) {
        glUseProgram(passes.programs.cloth.name());
        cloth_.draw(options.cloth_step, options.effort == Effort::quick);
    }
    glUseProgram(passes.programs.mast.name());
    mast_.draw();
    glUseProgram(passes.programs.obstacle.name());
    obstacles_.draw();
    draw_surroundings(passes);
    glDisable(GL_SCISSOR_TEST);
}

void Renderer::draw(const Frame& frame, const Camera& camera, const DrawTarget& target,
                    const DrawOptions& options) {
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_MULTISAMPLE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    Passes passes = passes_for(options);
    if (cloth_.update(frame)) shadow_cast_.reset();
    const auto shadowed = casters(options);
    passes.shadowed = shadowed.has_value();
    update_scene_block(camera, target, passes, shadowed);
    // A cloth at rest, seen from elsewhere, casts the shadow that stands in the map already.
    if (shadowed && shadow_cast_ != options) cast_shadows(passes, options);
    draw_scene(target, passes, options);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace weft
