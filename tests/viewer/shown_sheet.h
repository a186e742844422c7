// A flat sheet in the plane z = 0, shown by a camera on the z axis: what touch tests press on.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "viewer/cloth_touch.h"

namespace weft::viewer {

/// 11 x 11 particles from (-0.5, 0.5) to (0.5, -0.5); the two upper corners are pinned.
struct ShownSheet {
    static constexpr std::size_t side = 11, top_right = 10, middle = 60;

    std::vector<Vec3d> positions;
    Shown shown;
    std::vector<ViewArea> areas{{100, 50, 800, 600}};
    OrbitCamera camera{front_camera()};

    static Camera front_camera() {
        Camera camera;
        camera.eye = {0, 0, 3};
        return camera;
    }

    ShownSheet() {
        auto shape = std::make_shared<ClothShape>();
        for (std::size_t p = 0; p < side * side; ++p) {
            const double x = 0.1 * static_cast<double>(p % side) - 0.5;
            const double y = 0.5 - 0.1 * static_cast<double>(p / side);
            positions.push_back({x, y, 0.0});
        }
        shape->surface.particle_count = positions.size();
        shape->surface.uvs.resize(positions.size());
        for (std::uint32_t row = 0; row + 1 < side; ++row)
            for (std::uint32_t column = 0; column + 1 < side; ++column) {
                const auto p = static_cast<std::uint32_t>(row * side + column);
                const auto below = static_cast<std::uint32_t>(p + side);
                shape->surface.triangles.push_back({p, below, p + 1});
                shape->surface.triangles.push_back({p + 1, below, below + 1});
            }
        shape->pinned = {0, top_right};
        shape->stage.rest = {{-0.5F, -0.5F, 0.0F}, {0.5F, 0.5F, 0.0F}};
        shape->stage.size = 1.4F;
        shape->mass = 0.1;
        ShownCloth cloth;
        cloth.shape = std::move(shape);
        cloth.frame.positions = positions;
        shown.cloths.push_back(cloth);
    }
    ShownSheet(const ShownSheet&) = delete;

    [[nodiscard]] glm::vec2 pixel(glm::vec3 point, std::size_t cloth = 0) const {
        return *pixel_of(areas[cloth], camera.camera(), point);
    }
    [[nodiscard]] TouchTarget target(glm::vec2 at) const {
        const std::size_t cloth = *area_at(areas, at);
        return target_at(shown, CursorPlace(cloth, areas[cloth], at), camera.camera(), 9.0F);
    }
};

}  // namespace weft::viewer
