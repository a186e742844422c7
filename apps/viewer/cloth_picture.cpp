// Making renderers only where it must be: compiling their shaders takes longer than a frame.
#include "viewer/cloth_picture.h"

#include <algorithm>
#include <variant>

#include "weft/error.h"

namespace weft::viewer {

namespace {

bool same_obstacle(const ObstacleDescription& one, const ObstacleDescription& other) {
    if (one.shape.index() != other.shape.index()) return false;
    if (const auto* sphere = std::get_if<SphereObstacle>(&one.shape)) {
        const auto& second = std::get<SphereObstacle>(other.shape);
        return sphere->centre == second.centre && sphere->radius == second.radius;
    }
    const auto& first = std::get<PlaneObstacle>(one.shape);
    const auto& second = std::get<PlaneObstacle>(other.shape);
    return first.point == second.point && first.normal == second.normal;
}

}  // namespace

void ClothPicture::make_renderer(const RenderDescription& render) {
    trouble_.clear();
    try {
        renderer_ = std::make_unique<Renderer>(drawn_->surface, render);
    } catch (const Error& error) {
        trouble_ = error.what();
        RenderDescription plain = render;
        plain.texture = RenderDescription{}.texture;
        renderer_ = std::make_unique<Renderer>(drawn_->surface, plain);
    }
}

void ClothPicture::take(const std::shared_ptr<const ClothShape>& shape,
                        const RenderDescription& render,
                        const std::vector<ObstacleDescription>& obstacles) {
    const bool kept =
        renderer_ && render.texture == texture_ && drawn_->surface_number == shape->surface_number;
    if (!kept) {
        renderer_.reset();
        drawn_ = shape;
        texture_ = render.texture;
        make_renderer(render);
    }
    const bool same_stage = kept && shape == shape_ &&
                            std::equal(obstacles.begin(), obstacles.end(), obstacles_.begin(),
                                       obstacles_.end(), same_obstacle);
    shape_ = shape;
    if (same_stage) return;
    obstacles_ = obstacles;
    Stage stage = shape->stage;
    stage.obstacles = obstacles;
    renderer_->set_stage(stage);
}

}  // namespace weft::viewer
