#include "cloth/pins.h"

#include <fmt/format.h>

#include <algorithm>

#include "weft/error.h"

namespace weft {

namespace {

std::vector<std::size_t> edge_particles(const GridShape& shape, EdgeSelection edge) {
    const std::size_t last_i = shape.columns - 1, last_j = shape.rows - 1;
    std::vector<std::size_t> particles;
    const auto row = [&](std::size_t j) {
        for (std::size_t i = 0; i <= last_i; ++i) particles.push_back(shape.index(i, j));
    };
    const auto column = [&](std::size_t i) {
        for (std::size_t j = 0; j <= last_j; ++j) particles.push_back(shape.index(i, j));
    };
    switch (edge) {
        case EdgeSelection::top_left:
            return {shape.index(0, 0)};
        case EdgeSelection::top_right:
            return {shape.index(last_i, 0)};
        case EdgeSelection::bottom_left:
            return {shape.index(0, last_j)};
        case EdgeSelection::bottom_right:
            return {shape.index(last_i, last_j)};
        case EdgeSelection::left_edge:
            column(0);
            break;
        case EdgeSelection::right_edge:
            column(last_i);
            break;
        case EdgeSelection::top_edge:
            row(0);
            break;
        case EdgeSelection::bottom_edge:
            row(last_j);
            break;
    }
    return particles;
}

struct Select {
    const ClothModel& cloth;
    const std::string& key;

    std::vector<std::size_t> operator()(EdgeSelection edge) const {
        return edge_particles(cloth.shape, edge);
    }
    std::vector<std::size_t> operator()(const EverySelection& every) const {
        std::vector<std::size_t> particles;
        const std::vector<std::size_t> edge = edge_particles(cloth.shape, every.of);
        for (std::size_t n = 0; n < edge.size(); n += every.every) particles.push_back(edge[n]);
        return particles;
    }
    std::vector<std::size_t> operator()(const ParticleSelection& list) const {
        for (const std::size_t particle : list.particles) {
            if (particle >= cloth.particle_count) {
                throw scene_error(
                    key, fmt::format("particle {}", particle),
                    fmt::format("the cloth has particles 0 to {}", cloth.particle_count - 1));
            }
        }
        return list.particles;
    }
    std::vector<std::size_t> operator()(const BoxSelection& box) const {
        const auto inside = [](double x, double low, double high) { return low <= x && x <= high; };
        std::vector<std::size_t> particles;
        for (std::size_t p = 0; p < cloth.particle_count; ++p) {
            const Vec3d x = cloth.rest_position(p);
            if (inside(x.x, box.low.x, box.high.x) && inside(x.y, box.low.y, box.high.y) &&
                inside(x.z, box.low.z, box.high.z)) {
                particles.push_back(p);
            }
        }
        return particles;
    }
};

bool same_motion(const std::vector<PinKeyframe>& a, const std::vector<PinKeyframe>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const PinKeyframe& k, const PinKeyframe& l) {
                          return k.time == l.time && k.offset == l.offset;
                      });
}

}  // namespace

void place_pins(const SceneDescription& scene, ClothModel& cloth) {
    std::vector<std::size_t> owner(cloth.particle_count, scene.pins.size());  // which [[pins]]
    for (std::size_t n = 0; n < scene.pins.size(); ++n) {
        const PinDescription& pin = scene.pins[n];
        const std::string key = fmt::format("pins[{}].select", n);
        const std::vector<std::size_t> particles = std::visit(Select{cloth, key}, pin.select);
        if (particles.empty()) {
            throw scene_error(key, "a selector that picks no particle",
                              "at least one particle must lie in it");
        }
        for (const std::size_t p : particles) {
            if (owner[p] < n && !same_motion(scene.pins[owner[p]].motion, pin.motion)) {
                throw scene_error(
                    key, fmt::format("particle {}", cloth.particle_name(p)),
                    fmt::format("pins[{}] already holds it with another motion", owner[p]));
            }
            owner[p] = n;
        }
        if (!pin.motion.empty()) cloth.motions.push_back(pin.motion);
    }
    std::vector<std::uint32_t> motion_of(scene.pins.size(), Pin::no_motion);
    std::uint32_t motions = 0;
    for (std::size_t n = 0; n < scene.pins.size(); ++n) {
        if (!scene.pins[n].motion.empty()) motion_of[n] = motions++;
    }
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        if (owner[p] == scene.pins.size()) continue;
        cloth.pins.push_back(
            {static_cast<std::uint32_t>(p), motion_of[owner[p]], cloth.rest_position(p)});
    }
}

PinOffset pin_offset(const std::vector<PinKeyframe>& motion, double time) {
    if (time <= motion.front().time) return {motion.front().offset, {}, {}};
    if (time >= motion.back().time) return {motion.back().offset, {}, {}};
    const auto next =
        std::upper_bound(motion.begin(), motion.end(), time,
                         [](double t, const PinKeyframe& keyframe) { return t < keyframe.time; });
    const PinKeyframe &from = *(next - 1), &to = *next;
    const double span = to.time - from.time;
    const double s = (time - from.time) / span;
    const Vec3d way = to.offset - from.offset;
    return {from.offset + (s * s * (3 - 2 * s)) * way, (6 * s * (1 - s) / span) * way,
            ((6 - 12 * s) / (span * span)) * way};
}

}  // namespace weft
