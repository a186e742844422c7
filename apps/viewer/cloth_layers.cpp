// Which layers there are, and how each looks.
#include "viewer/cloth_layers.h"

#include "viewer/touch_target.h"

namespace weft::viewer {

namespace {

constexpr float normal_length = 0.03F;  // of the cloth's size
constexpr float wind_seconds = 0.04F;   // that an arrow's length stands for, a metre of size
constexpr std::array<std::uint8_t, 4> handle_colour{240, 170, 60, 255};

void add_handles(const ShownCloth& cloth, const Shown& shown, OverlayList& list) {
    for (const PlaneHandle& handle : plane_handles(shown.obstacles, cloth.shape->stage)) {
        const glm::vec3 arrow = handle.length * handle.normal;
        add_arrow(handle.middle, handle.middle + arrow, handle_colour, list);
        add_arrow(handle.middle, handle.middle - arrow, handle_colour, list);
    }
}

}  // namespace

std::vector<Layer> layers_of(const WindowSettings& settings, const ShownCloth& cloth,
                             const Shown& shown) {
    const ClothShape& shape = *cloth.shape;
    std::vector<Layer> layers;
    const auto add = [&layers](bool wanted, Layer layer) {
        if (wanted) layers.push_back(layer);
    };
    add(settings.springs == 1 && !shape.springs.empty(), Layer::springs_by_strain);
    add(settings.springs == 2 && !shape.springs.empty(), Layer::springs_by_kind);
    add(settings.wireframe, Layer::wireframe);
    add(settings.particles, Layer::particles);
    add(settings.normals, Layer::normals);
    add(settings.wind_arrows && length(shown.wind) > 0.0, Layer::wind);
    add(settings.pins && !shape.pinned.empty(), Layer::pins);
    add(shown.touchable && !plane_handles(shown.obstacles, shape.stage).empty(), Layer::handles);
    return layers;
}

LayerStyle style_of(Layer layer, const ClothShape& shape) {
    // On fine cloths thick lines would cover all, and lines of one pixel are drawn twice as fast.
    const bool fine = shape.surface.particle_count > 8000;
    switch (layer) {
        case Layer::wireframe:
        case Layer::normals:
            return {false, 1.0F};
        case Layer::springs_by_strain:
        case Layer::springs_by_kind:
            return {false, fine ? 1.0F : 1.5F};
        case Layer::wind:
            return {false, 2.0F};
        case Layer::handles:
            return {false, 3.0F};
        case Layer::particles:
            return {true, fine ? 2.5F : 4.0F};
        case Layer::pins:
            break;
    }
    constexpr std::size_t few = 12;  // else they stand in rows, and should not touch
    return {true, shape.pinned.size() <= few ? 9.0F : 5.0F};
}

void add_layer(Layer layer, const ShownCloth& cloth, const Shown& shown, float strain_range,
               OverlayList& list) {
    const ClothShape& shape = *cloth.shape;
    const float size = shape.stage.size;
    switch (layer) {
        case Layer::wireframe:
            return add_wireframe(shape.edges, cloth.frame, list);
        case Layer::springs_by_strain:
            return add_springs_by_strain(shape.springs, {}, cloth.frame, strain_range, list);
        case Layer::springs_by_kind:
            return add_springs_by_kind(shape.springs, {}, cloth.frame, list);
        case Layer::particles:
            return add_particles(cloth.frame, list);
        case Layer::normals:
            return add_normals(cloth.frame, normal_length * size, list);
        case Layer::wind:
            return add_wind(shape.stage.rest, to_glm(shown.wind), wind_seconds * size, list);
        case Layer::pins:
            return add_pins(shape.pinned, cloth.frame, list);
        case Layer::handles:
            return add_handles(cloth, shown, list);
    }
}

void ClothLayers::draw(std::span<const Layer> layers, const ShownCloth& cloth, const Shown& shown,
                       float strain_range, float scale, const Camera& camera,
                       const DrawTarget& target) {
    for (const Layer layer : layers) {
        list_.clear();
        add_layer(layer, cloth, shown, strain_range, list_);
        const LayerStyle style = style_of(layer, *cloth.shape);
        if (style.points)
            overlay_.draw_points(list_, scale * style.width, camera, target);
        else
            overlay_.draw_lines(list_, scale * style.width, camera, target);
    }
}

}  // namespace weft::viewer
