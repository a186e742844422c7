// The rules of scene values: every range, and every combination of values that cannot be.
#include "simulation/scene_check.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "math/nearest_name.h"
#include "math/quoting.h"
#include "simulation/scene_require.h"
#include "simulation/scene_rules.h"
#include "simulation/scene_words.h"
#include "weft/error.h"
#include "weft/integrators.h"
#include "weft/scene.h"

namespace weft {

namespace {

bool is_positive(double value) {
    return std::isfinite(value) && value > 0.0;
}

void require_positive(const std::string& key, double value) {
    require(is_positive(value), key, value_text(value), scene_rules::positive);
}

/// Refuses a name that is not in a catalogue, with the nearest one that is.
/// @param others names that are allowed besides.
template <typename Catalogue>
void require_known(const std::string& key, const std::string& name, const Catalogue& catalogue,
                   std::vector<std::string_view> others = {}) {
    std::vector<std::string_view>& names = others;
    for (const auto& row : catalogue) names.push_back(row.name);
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    throw scene_error(key, in_quotes(name),
                      fmt::format("{}{}", fmt::join(names, ", "), did_you_mean(name, names)));
}

void check_grid(const GridDescription& grid) {
    require(is_positive(grid.size[0]) && is_positive(grid.size[1]), "cloth.size",
            value_text(grid.size), scene_rules::sheet_size);
    require(grid.resolution[0] >= 2 && grid.resolution[1] >= 2, "cloth.resolution",
            value_text(grid.resolution), scene_rules::resolution);
    require_finite("cloth.origin", grid.origin);
}

void check_mesh(const ClothDescription& cloth) {
    require(cloth.mesh != nullptr || cloth.mesh_path.empty(), "cloth.mesh",
            in_quotes(cloth.mesh_path), "a path whose mesh has been loaded");
}

/// The particles have to be numbered and to fit into memory. A mesh is in memory already.
void check_size(const SceneDescription& scene) {
    const double particles = particle_estimate(scene);
    const std::string key = scene.cloth.mesh ? "cloth.mesh" : "cloth.resolution";
    const std::string value = scene.cloth.mesh ? in_quotes(scene.cloth.mesh_path)
                                               : value_text(scene.cloth.grid.resolution);
    constexpr double most_particles = std::numeric_limits<std::uint32_t>::max() - 1.0;
    require(
        particles <= most_particles, key, value,
        fmt::format("at most {:.0f} particles, as they are numbered in 32 bits", most_particles));
    const double needed = estimate_memory(scene);
    if (needed <= machine_memory()) return;
    constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
    const std::string reason = fmt::format(
        "{} is not allowed: {:.0f} particles take about {:.1f} GiB, more than this machine has",
        value, particles, needed / gibibyte);
    throw Error(ErrorKind::usage, {.file = {}, .key = key}, reason,
                fmt::format("This machine has {:.1f} GiB of memory.", machine_memory() / gibibyte));
}

void check_springs(const std::string& kind, const SpringMaterial& spring) {
    require_not_negative("material." + kind + ".stiffness", spring.stiffness);
    require_not_negative("material." + kind + ".damping", spring.damping);
}

void check_material(const MaterialDescription& material, bool grid) {
    require_known("material.fabric", material.fabric, fabric_catalogue());
    if (material.particle_mass) {
        require_positive("material.particle_mass", *material.particle_mass);
    } else {
        require_positive("material.mass_per_area", material.mass_per_area);
    }
    check_springs("structural", material.structural);
    check_springs("shear", material.shear);
    check_springs("bend", material.bend);
    require(grid || material.bend_layout == BendLayout::interior, "material.bend.layout",
            in_quotes(scene_word(material.bend_layout)),
            "\"interior\" with cloth.mesh; only a grid has border lines");
}

/// Checks one pin's selector; `key` is "pins[0].select".
struct SelectorCheck {
    const std::string& key;
    const ClothDescription& cloth;

    void operator()(EdgeSelection edge) const { require_grid(edge); }

    void operator()(const ParticleSelection& selection) const {
        require(!selection.particles.empty(), key, "{ particles = [] }", "at least one particle");
        if (cloth.mesh) return;  // its particles are counted after welding, when it is built
        const auto count = static_cast<std::size_t>(cloth.grid.resolution[0]) *
                           static_cast<std::size_t>(cloth.grid.resolution[1]);
        for (const std::size_t particle : selection.particles) {
            require(particle < count, key, fmt::format("particle {}", particle),
                    fmt::format("0 to {} in a grid of {} x {}", count - 1, cloth.grid.resolution[0],
                                cloth.grid.resolution[1]));
        }
    }

    void operator()(const EverySelection& selection) const {
        require(selection.every >= 1, key, fmt::format("every = {}", selection.every),
                "an integer, at least 1");
        require(is_edge(selection.of), key, fmt::format("of = \"{}\"", scene_word(selection.of)),
                "\"left-edge\", \"right-edge\", \"top-edge\" or \"bottom-edge\"");
        require_grid(selection.of);
    }

    void operator()(const BoxSelection& box) const {
        const auto [low, high] = box;
        const bool ordered = low.x <= high.x && low.y <= high.y && low.z <= high.z;
        require(is_finite(low) && is_finite(high) && ordered, key,
                fmt::format("box = [{}, {}]", value_text(low), value_text(high)),
                "two corners of finite numbers, none of the first above that of the second");
    }

private:
    void require_grid(EdgeSelection edge) const {
        require(!cloth.mesh, key, in_quotes(scene_word(edge)),
                "{ particles = [...] } or { box = [...] } with cloth.mesh; only a grid has edges");
    }
};

void check_pin(const std::string& pin_key, const PinDescription& pin,
               const ClothDescription& cloth) {
    const std::string select_key = pin_key + ".select";
    std::visit(SelectorCheck{select_key, cloth}, pin.select);
    for (std::size_t i = 0; i < pin.motion.size(); ++i) {
        const PinKeyframe& keyframe = pin.motion[i];
        const std::string key = fmt::format("{}.motion[{}]", pin_key, i);
        require(std::isfinite(keyframe.time), key + ".time", value_text(keyframe.time),
                "a finite number");
        require(i == 0 || keyframe.time > pin.motion[i - 1].time, key + ".time",
                value_text(keyframe.time), "later than the keyframe before");
        require_finite(key + ".offset", keyframe.offset);
    }
}

void check_obstacle(const std::string& key, const ObstacleDescription& obstacle) {
    if (const auto* const sphere = std::get_if<SphereObstacle>(&obstacle.shape)) {
        require_finite(key + ".sphere.centre", sphere->centre);
        require_positive(key + ".sphere.radius", sphere->radius);
    } else {
        const auto& plane = std::get<PlaneObstacle>(obstacle.shape);
        require_finite(key + ".plane.point", plane.point);
        require(is_finite(plane.normal) && plane.normal != Vec3d{}, key + ".plane.normal",
                value_text(plane.normal), scene_rules::normal);
    }
    require(obstacle.friction >= 0.0 && obstacle.friction <= 10.0, key + ".friction",
            value_text(obstacle.friction), scene_rules::friction);
    require(obstacle.gap >= 0.0 && obstacle.gap <= 1.0, key + ".gap", value_text(obstacle.gap),
            scene_rules::gap);
}

void check_obstacles(const SceneDescription& scene) {
    constexpr std::size_t most = 64;  // every particle looks at each
    require(scene.obstacles.size() <= most, "obstacles",
            fmt::format("a list of {}", scene.obstacles.size()), fmt::format("at most {}", most));
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
        check_obstacle(fmt::format("obstacles[{}]", i), scene.obstacles[i]);
    }
    require(scene.obstacles.empty() || !scene.output.settle, "output.settle", "true",
            scene_rules::settle_among_obstacles);
}

// Whether it has as many particles as the cloth shows once a mesh is welded, when it is built.
void check_start(const SceneDescription& scene) {
    const StartDescription& start = scene.start;
    require_not_negative("start.time", start.time);
    require(start.state != nullptr || start.state_path.empty(), "start.state",
            in_quotes(start.state_path), "a path whose state has been loaded");
    if (!start.state) return;
    const auto& [x, v] = *start.state;
    require(x.size() == v.size(), "start.state",
            fmt::format("a state of {} positions and {} velocities", x.size(), v.size()),
            "as many of both");
    for (std::size_t p = 0; p < x.size(); ++p) {
        if (is_finite(x[p]) && is_finite(v[p])) continue;
        throw scene_error("start.state",
                          fmt::format("position {} and velocity {} of particle {}",
                                      value_text(x[p]), value_text(v[p]), p),
                          "finite numbers");
    }
    if (scene.cloth.mesh) return;
    const double particles = particle_estimate(scene);
    require(static_cast<double>(x.size()) == particles, "start.state",
            fmt::format("a state of {} particles", x.size()),
            fmt::format("{:.0f} in a grid of {} x {}", particles, scene.cloth.grid.resolution[0],
                        scene.cloth.grid.resolution[1]));
}

void check_forces(const SceneDescription& scene) {
    require_finite("forces.gravity", scene.forces.gravity);
    require_not_negative("forces.damping", scene.forces.damping);
    if (!scene.wind) return;
    const WindDescription& wind = *scene.wind;
    require_finite("wind.velocity", wind.velocity);
    require_not_negative("wind.air_density", wind.air_density);
    require_not_negative("wind.drag", wind.drag);
    require_not_negative("wind.skin_friction", wind.skin_friction);
    require(wind.gust.spread >= 0.0 && wind.gust.spread < 1.0, "wind.gust.spread",
            value_text(wind.gust.spread), scene_rules::spread);
    require_positive("wind.gust.period", wind.gust.period);
}

void check_times(const IntegratorDescription& integrator, const OutputDescription& output) {
    constexpr double most = 1e9;  // frames in a run, and steps in a frame: both are counted
    require_known("integrator.method", integrator.method, integrator_catalogue(), {"auto"});
    require_not_negative("output.duration", output.duration);
    require_positive("output.frames_per_second", output.frames_per_second);
    require(
        output.duration * output.frames_per_second <= most, "output.duration",
        value_text(output.duration),
        fmt::format("at most {} frames at {} frames per second", most, output.frames_per_second));
    if (integrator.tolerance) {
        require(is_positive(*integrator.tolerance), "integrator.tolerance",
                value_text(*integrator.tolerance), scene_rules::tolerance);
    }
    if (integrator.iterations) {
        require(*integrator.iterations >= 1 && *integrator.iterations <= 100'000,
                "integrator.iterations", fmt::format("{}", *integrator.iterations),
                scene_rules::iterations);
    }
    if (!integrator.time_step) return;
    const double step = *integrator.time_step;
    require(is_positive(step), "integrator.time_step", value_text(step), scene_rules::time_step);
    require(1.0 <= most * step * output.frames_per_second, "integrator.time_step", value_text(step),
            fmt::format("at most {} steps a frame at {} frames per second", most,
                        output.frames_per_second));
}

// Which solvers there are depends on the cloth; what rests needs something to hold it.
void check_implicit(const SceneDescription& scene) {
    const LinearSolver solver = scene.integrator.linear_solver;
    require(
        solver != LinearSolver::multigrid || !scene.cloth.mesh, "integrator.linear_solver",
        in_quotes(scene_word(solver)),
        "\"auto\", \"aggregation\", \"jacobi\" or \"cholesky\" with cloth.mesh; only a grid has "
        "coarser grids");
    const bool falls = scene.forces.gravity != Vec3d{} || scene.wind;
    require(!scene.output.settle || !scene.pins.empty() || !falls, "output.settle", "true",
            "false without [[pins]]; a cloth that nothing holds comes to no rest");
}

void check_render(const RenderDescription& render) {
    for (const int pixels : render.size) {
        require(pixels >= 16 && pixels <= 8192 && pixels % 2 == 0, "render.size",
                value_text(render.size), scene_rules::picture_size);
    }
    require(render.field_of_view > 0.0 && render.field_of_view < 180.0, "render.field_of_view",
            value_text(render.field_of_view), scene_rules::field_of_view);
    if (render.camera) require_finite("render.camera", *render.camera);
    if (render.target) require_finite("render.target", *render.target);
    require(!render.camera || !render.target || *render.camera != *render.target, "render.target",
            value_text(render.target.value_or(Vec3d{})), "another place than render.camera");
}

bool is_one_line(const std::string& name) {
    return !name.empty() && std::none_of(name.begin(), name.end(), [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return code < 0x20 || code == 0x7f;
    });
}

// What a method keeps for each particle [bytes]: measured on sheets of 400 x 400, rounded up.
double method_memory(const IntegratorDescription& integrator) {
    const IntegratorInfo* const info = find_integrator(integrator.method);
    if (info == nullptr || info->kind == IntegratorKind::explicit_steps) return 250.0;
    if (info->kind == IntegratorKind::adaptive) return 400.0;
    if (info->name == "projective-dynamics") return 4000.0;
    if (info->kind == IntegratorKind::by_springs) return 900.0;
    return integrator.linear_solver == LinearSolver::cholesky ? 10'000.0 : 1600.0;
}

}  // namespace

double particle_estimate(const SceneDescription& scene) {
    if (scene.cloth.mesh) return static_cast<double>(scene.cloth.mesh->positions.size());
    const auto& resolution = scene.cloth.grid.resolution;
    return static_cast<double>(resolution[0]) * static_cast<double>(resolution[1]);
}

double estimate_memory(const SceneDescription& scene) {
    double bytes_per_particle = method_memory(scene.integrator) + 300.0;
    const auto& formats = scene.output.formats;
    if (std::find(formats.begin(), formats.end(), "glb") != formats.end()) {
        const double frames = scene.output.duration * scene.output.frames_per_second + 1.0;
        bytes_per_particle += 24.0 * std::clamp(frames, 1.0, 250.0);
    }
    return bytes_per_particle * particle_estimate(scene);
}

double machine_memory() {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long page_size = sysconf(_SC_PAGE_SIZE);
    if (pages <= 0 || page_size <= 0) return std::numeric_limits<double>::infinity();
    return static_cast<double>(pages) * static_cast<double>(page_size);
}

std::size_t SceneDescription::frame_count() const {
    return static_cast<std::size_t>(std::llround(output.duration * output.frames_per_second));
}

void check_scene(const SceneDescription& scene) {
    require(is_one_line(scene.name), "name", in_quotes(scene.name), scene_rules::name);
    check_mesh(scene.cloth);
    if (!scene.cloth.mesh) check_grid(scene.cloth.grid);
    check_material(scene.material, !scene.cloth.mesh);
    for (std::size_t i = 0; i < scene.pins.size(); ++i) {
        check_pin(fmt::format("pins[{}]", i), scene.pins[i], scene.cloth);
    }
    check_obstacles(scene);
    check_start(scene);
    check_forces(scene);
    check_times(scene.integrator, scene.output);
    check_implicit(scene);
    check_render(scene.render);
    check_size(scene);
}

}  // namespace weft
