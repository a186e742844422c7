// One cloth's own drawing: a Renderer that is kept while only the cloth's pins or stage change.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "viewer/shown_cloth.h"

namespace weft::viewer {

/// Made, used and destroyed while one OpenGL context is current.
class ClothPicture {
public:
    /// Takes over a cloth's surface and texture where they changed, and its stage with obstacles.
    /// A texture that cannot be read is replaced by the flag's.
    void take(const std::shared_ptr<const ClothShape>& shape, const RenderDescription& render,
              const std::vector<ObstacleDescription>& obstacles);
    /// @pre take() was called.
    void draw(const Frame& frame, const Camera& camera, const DrawTarget& target,
              const DrawOptions& options) {
        renderer_->draw(frame, camera, target, options);
    }
    /// Why the texture was replaced; empty: it was not.
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

private:
    void make_renderer(const RenderDescription& render);

    std::shared_ptr<const ClothShape> drawn_;  ///< whose surface the renderer has
    std::shared_ptr<const ClothShape> shape_;  ///< whose stage it has
    std::string texture_, trouble_;
    std::vector<ObstacleDescription> obstacles_;
    std::unique_ptr<Renderer> renderer_;
};

}  // namespace weft::viewer
