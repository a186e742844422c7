#include "viewer/cloth_shape.h"

#include <atomic>
#include <utility>

#include "cloth/cloth_model.h"

namespace weft::viewer {

std::uint64_t new_surface_number() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

std::shared_ptr<const ClothShape> make_cloth_shape(const SceneDescription& scene,
                                                   std::uint64_t surface_number) {
    ClothModel cloth = build_cloth(scene);
    auto shape = std::make_shared<ClothShape>();
    shape->surface_number = surface_number;
    shape->mass = cloth.total_mass();
    for (const Pin& pin : cloth.pins) shape->pinned.push_back(pin.particle);
    const auto counts = cloth.spring_counts();
    shape->springs.reserve(counts[0] + counts[1] + counts[2]);
    cloth.for_each_spring([&](const Spring& spring, const SpringConstants&) {
        shape->springs.push_back({spring.p, spring.q, static_cast<float>(spring.rest_length),
                                  static_cast<std::uint8_t>(spring.kind)});
    });
    std::vector<Vec3d> rest(cloth.particle_count);
    for (std::size_t p = 0; p < rest.size(); ++p) rest[p] = cloth.rest_position(p);
    shape->surface = std::move(cloth.surface);
    shape->edges = edges_of(shape->surface);
    shape->stage = plan_stage(shape->surface, rest, scene.render, scene.obstacles);
    return shape;
}

}  // namespace weft::viewer
