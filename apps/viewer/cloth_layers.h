// What is drawn over a cloth: wireframe, springs, particles, normals, wind, pins, planes' handles.
#pragma once

#include <span>
#include <vector>

#include "render/overlay.h"
#include "render/overlay_shapes.h"
#include "viewer/shown_cloth.h"
#include "viewer/window_settings.h"

namespace weft::viewer {

enum class Layer {
    wireframe,
    springs_by_strain,
    springs_by_kind,
    particles,
    normals,
    wind,
    pins,
    handles
};

/// The layers to be drawn, in order: what settings ask for and the cloth has.
std::vector<Layer> layers_of(const WindowSettings& settings, const ShownCloth& cloth,
                             const Shown& shown);

/// How a layer's list is drawn.
struct LayerStyle {
    bool points = false;  ///< else lines
    float width = 1.0F;   ///< of a line, or diameter of a point [screen units]
};
LayerStyle style_of(Layer layer, const ClothShape& shape);

/// Appends the vertices of a layer.
void add_layer(Layer layer, const ShownCloth& cloth, const Shown& shown, float strain_range,
               OverlayList& list);

/// Draws layers with OpenGL, reusing one list.
class ClothLayers {
public:
    void draw(std::span<const Layer> layers, const ShownCloth& cloth, const Shown& shown,
              float strain_range, float scale, const Camera& camera, const DrawTarget& target);

private:
    Overlay overlay_;
    OverlayList list_;
};

}  // namespace weft::viewer
