// Making renderers only where it must be: compiling their shaders takes longer than a frame.
#include "viewer/cloth_picture.h"

#include <algorithm>

#include "weft/error.h"

namespace weft::viewer {

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
    const bool same_stage =
        kept && shape == shape_ &&
        std::ranges::equal(obstacles, obstacles_, {}, &ObstacleDescription::shape,
                           &ObstacleDescription::shape);
    shape_ = shape;
    if (same_stage) return;
    obstacles_ = obstacles;
    Stage stage = shape->stage;
    stage.obstacles = obstacles;
    renderer_->set_stage(stage);
}

}  // namespace weft::viewer
