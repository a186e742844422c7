#include "viewer/scene_edits.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "cloth/cloth_model.h"
#include "cloth/pins.h"
#include "weft/error.h"

namespace weft::viewer {

namespace {

using Motion = std::vector<PinKeyframe>;
using Particles = std::vector<std::size_t>;

/// As much of a cloth as selectors and rest positions need.
ClothModel unpinned_cloth(const SceneDescription& scene) {
    if (scene.cloth.mesh) {
        SceneDescription unpinned = scene;
        unpinned.pins.clear();
        return build_cloth(unpinned);
    }
    ClothModel cloth;
    cloth.grid = scene.cloth.grid;
    cloth.shape = grid_shape(scene.cloth.grid);
    cloth.particle_count = cloth.shape.particle_count();
    return cloth;
}

/// What a selector picks, in rising order, or as the scene lists it.
Particles selected(const PinSelector& select, ClothModel& cloth) {
    if (const auto* list = std::get_if<ParticleSelection>(&select)) return list->particles;
    SceneDescription alone;
    alone.pins = {{select, {}}};
    place_pins(alone, cloth);
    Particles particles;
    for (const Pin& pin : std::exchange(cloth.pins, {})) particles.push_back(pin.particle);
    return particles;
}

/// Takes a particle out of every pin that holds it; pins left with none go.
/// @return its motion; none: nothing held it.
std::optional<Motion> take_out(SceneDescription& scene, ClothModel& cloth, std::size_t particle) {
    std::optional<Motion> motion;
    std::vector<PinDescription> kept;
    for (PinDescription& pin : scene.pins) {
        Particles particles = selected(pin.select, cloth);
        if (std::erase(particles, particle) > 0) {
            motion = pin.motion;  // several pins that hold it all have the same
            pin.select = ParticleSelection{particles};
        }
        if (!particles.empty()) kept.push_back(std::move(pin));
    }
    scene.pins = std::move(kept);
    return motion;
}

/// Pins a particle that nothing holds, with others of the same motion where these are listed.
void put_in(SceneDescription& scene, std::size_t particle, const Motion& motion) {
    for (PinDescription& pin : scene.pins) {
        auto* const list = std::get_if<ParticleSelection>(&pin.select);
        if (list == nullptr || pin.motion != motion) continue;
        list->particles.push_back(particle);
        return;
    }
    scene.pins.push_back({ParticleSelection{{particle}}, motion});
}

Motion shifted(Motion motion, Vec3d shift) {
    // One keyframe is an offset for all times.
    if (motion.empty()) motion.push_back({});
    for (PinKeyframe& keyframe : motion) keyframe.offset += shift;
    return motion;
}

/// `index` of `old_count` places along a line, in `count` places along the same line.
std::size_t nearest_place(std::size_t index, int old_count, int count) {
    const double part = static_cast<double>(index) / (old_count - 1.0);
    return static_cast<std::size_t>(std::lround(part * (count - 1.0)));
}

bool is_grid_allowed(const SceneDescription& scene) {
    SceneDescription alone;
    alone.cloth = scene.cloth;
    alone.pins.clear();
    try {
        check_scene(alone);
    } catch (const Error&) {
        return false;
    }
    return true;
}

/// By particle, whether a selector by place holds it: an edge, a corner, a box.
std::vector<bool> held_by_place(const SceneDescription& scene) {
    ClothModel cloth = unpinned_cloth(scene);
    std::vector<bool> held(cloth.particle_count);
    for (const PinDescription& pin : scene.pins) {
        if (std::holds_alternative<ParticleSelection>(pin.select)) continue;
        try {
            for (const std::size_t particle : selected(pin.select, cloth)) held[particle] = true;
        } catch (const Error&) {
            continue;  // a box that holds nothing on this grid: building the cloth says so
        }
    }
    return held;
}

/// Takes pins from one resolution to another.
struct Resample {
    std::array<int, 2> from, to;

    void operator()(SceneDescription& scene) const {
        for (PinDescription& pin : scene.pins) {
            if (auto* const every = std::get_if<EverySelection>(&pin.select)) space(*every);
        }
        std::vector<bool> held = held_by_place(scene);
        for (PinDescription& pin : scene.pins) {
            if (auto* const list = std::get_if<ParticleSelection>(&pin.select)) move(*list, held);
        }
        std::erase_if(scene.pins, [](const PinDescription& pin) {
            const auto* const list = std::get_if<ParticleSelection>(&pin.select);
            return list != nullptr && list->particles.empty();
        });
    }

private:
    void space(EverySelection& every) const {
        const bool down =
            every.of == EdgeSelection::left_edge || every.of == EdgeSelection::right_edge;
        const std::size_t line = down ? 1 : 0;
        every.every = std::max<std::size_t>(nearest_place(every.every, from[line], to[line]), 1);
    }
    /// On a coarser grid two may meet; then the first keeps its motion.
    void move(ParticleSelection& list, std::vector<bool>& held) const {
        const auto old_columns = static_cast<std::size_t>(from[0]);
        const auto columns = static_cast<std::size_t>(to[0]);
        Particles moved;
        for (const std::size_t p : list.particles) {
            const std::size_t place = nearest_place(p / old_columns, from[1], to[1]) * columns +
                                      nearest_place(p % old_columns, from[0], to[0]);
            if (!held[place]) moved.push_back(place);
            held[place] = true;
        }
        list.particles = std::move(moved);
    }
};

}  // namespace

SceneDescription with_pin_toggled(const SceneDescription& scene, std::size_t particle,
                                  Vec3d offset) {
    ClothModel cloth = unpinned_cloth(scene);
    if (particle >= cloth.particle_count) return scene;
    SceneDescription edited = scene;
    if (take_out(edited, cloth, particle)) {
        // A cloth that nothing holds comes to no rest.
        if (edited.pins.empty()) edited.output.settle = false;
        return edited;
    }
    put_in(edited, particle, offset == Vec3d{} ? Motion{} : shifted({}, offset));
    return edited;
}

SceneDescription with_pin_moved(const SceneDescription& scene, std::size_t particle, Vec3d shift) {
    ClothModel cloth = unpinned_cloth(scene);
    SceneDescription edited = scene;
    const std::optional<Motion> motion = take_out(edited, cloth, particle);
    if (motion) put_in(edited, particle, shifted(*motion, shift));
    return edited;
}

Vec3d rest_position(const SceneDescription& scene, std::size_t particle) {
    return unpinned_cloth(scene).rest_position(particle);
}

SceneDescription with_obstacle(const SceneDescription& scene, const ObstacleDescription& added) {
    SceneDescription edited = scene;
    edited.obstacles.push_back(added);
    return edited;
}

SceneDescription without_obstacle(const SceneDescription& scene, std::size_t obstacle) {
    SceneDescription edited = scene;
    if (obstacle >= edited.obstacles.size()) return edited;
    edited.obstacles.erase(edited.obstacles.begin() + static_cast<std::ptrdiff_t>(obstacle));
    return edited;
}

SceneDescription with_obstacle_moved(const SceneDescription& scene, std::size_t obstacle,
                                     Vec3d shift) {
    SceneDescription edited = scene;
    if (obstacle >= edited.obstacles.size()) return edited;
    auto& shape = edited.obstacles[obstacle].shape;
    if (auto* const sphere = std::get_if<SphereObstacle>(&shape)) {
        sphere->centre += shift;
    } else {
        std::get<PlaneObstacle>(shape).point += shift;
    }
    return edited;
}

SceneDescription with_method(const SceneDescription& scene, std::string_view method) {
    SceneDescription edited = scene;
    edited.integrator.method = method;
    return edited;
}

SceneDescription with_fabric(const SceneDescription& scene, std::string_view fabric) {
    SceneDescription edited = scene;
    MaterialDescription& material = edited.material;
    for (const FabricInfo& info : fabric_catalogue()) {
        if (info.name != fabric) continue;
        material.fabric = info.name;
        material.mass_per_area = info.mass_per_area;
        material.particle_mass.reset();
        material.stiffness_per = StiffnessPer::width;
        material.structural = info.structural;
        material.shear = info.shear;
        material.bend = info.bend;
    }
    return edited;
}

SceneDescription with_wind(const SceneDescription& scene, bool wind) {
    SceneDescription edited = scene;
    if (!wind) {
        edited.wind.reset();
    } else if (!edited.wind) {
        edited.wind.emplace().velocity = {};
    }
    return edited;
}

SceneDescription with_gusts(const SceneDescription& scene, bool gusts) {
    SceneDescription edited = scene;
    if (edited.wind) edited.wind->gust.model = gusts ? GustModel::coefficient : GustModel::none;
    return edited;
}

SceneDescription with_resolution(const SceneDescription& scene, std::array<int, 2> resolution) {
    SceneDescription edited = scene;
    edited.start = {};
    const std::array<int, 2> old = std::exchange(edited.cloth.grid.resolution, resolution);
    if (is_grid_allowed(edited)) Resample{old, resolution}(edited);
    return edited;
}

SceneDescription with_start(const SceneDescription& scene, std::span<const Vec3d> positions,
                            std::span<const Vec3d> velocities, double time) {
    SceneDescription edited = scene;
    edited.start.state_path.clear();
    edited.start.state = std::make_shared<const ClothState>(
        ClothState{{positions.begin(), positions.end()}, {velocities.begin(), velocities.end()}});
    edited.start.time = time;
    edited.output.settle = false;  // it would leave what is on the screen
    return edited;
}

}  // namespace weft::viewer
