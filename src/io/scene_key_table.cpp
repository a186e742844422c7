// The table of scene keys itself. A default is that of SceneDescription{}, the shipped flag.
#include "io/scene_keys.h"
#include "simulation/scene_rules.h"

namespace weft {

namespace {

using S = SceneDescription;
using Index = std::size_t;

bool has_grid(const S& s, Index) {
    return s.cloth.mesh == nullptr;
}
bool has_mesh(const S& s, Index) {
    return s.cloth.mesh != nullptr;
}
bool has_particle_mass(const S& s, Index) {
    return s.material.particle_mass.has_value();
}
bool has_mass_per_area(const S& s, Index) {
    return !s.material.particle_mass.has_value();
}
bool has_wind(const S& s, Index) {
    return s.wind.has_value();
}
bool has_gust(const S& s, Index) {
    return s.wind && s.wind->gust.model != GustModel::none;
}
bool has_no_gust(const S& s, Index) {
    return s.wind && s.wind->gust.model == GustModel::none;
}

bool is_sphere(const S& s, Index obstacle) {
    return std::holds_alternative<SphereObstacle>(s.obstacles.at(obstacle).shape);
}
bool is_plane(const S& s, Index obstacle) {
    return std::holds_alternative<PlaneObstacle>(s.obstacles.at(obstacle).shape);
}
bool has_start_state(const S& s, Index) {
    return s.start.state != nullptr;
}
bool begins_elsewhere(const S& s, Index) {
    return s.start.state != nullptr || s.start.time != 0.0;
}

SphereObstacle& sphere(S& s, Index obstacle) {
    return std::get<SphereObstacle>(s.obstacles.at(obstacle).shape);
}
PlaneObstacle& plane(S& s, Index obstacle) {
    return std::get<PlaneObstacle>(s.obstacles.at(obstacle).shape);
}

constexpr std::array lists{
    SceneList{"pins", +[](const S& s) { return s.pins.size(); },
              +[](S& s, std::size_t count) { s.pins.assign(count, {}); }},
    SceneList{"obstacles", +[](const S& s) { return s.obstacles.size(); },
              +[](S& s, std::size_t count) { s.obstacles.assign(count, {}); }},
};

constexpr std::string_view fabric_names = "a fabric of `weft list fabrics`";
constexpr std::string_view yes_or_no = "true or false";
constexpr std::string_view selectors =
    "\"top-left\", \"top-right\", \"bottom-left\", \"bottom-right\", \"left-edge\", "
    "\"right-edge\", "
    "\"top-edge\", \"bottom-edge\", { particles = [0, 40] }, { every = 10, of = \"top-edge\" } or "
    "{ box = [[x, y, z], [x, y, z]] }";

// clang-format off
const std::array table{
    SceneKey{"version", "", "1", "1",
        "Version of this format. Required.", {}},
    SceneKey{"name", "", "\"Flag in the wind\"", scene_rules::name,
        "Title of the scene. Where [cloth] is given, the default is the file's name.",
        +[](S& s, Index) -> std::string& { return s.name; }},

    SceneKey{"cloth.size", "m", "[1.5, 1.0]", scene_rules::sheet_size,
        "Width and height of the sheet.",
        +[](S& s, Index) -> std::array<double, 2>& { return s.cloth.grid.size; }, has_grid},
    SceneKey{"cloth.resolution", "", "[61, 41]", scene_rules::resolution,
        "Columns and rows of particles; the particle in column i and row j has the number j * columns + i.",
        +[](S& s, Index) -> std::array<int, 2>& { return s.cloth.grid.resolution; }, has_grid},
    SceneKey{"cloth.plane", "", "\"xy\"", "\"xy\" or \"xz\"",
        "\"xy\": hangs, rows run downward (-y). \"xz\": lies flat, rows run along +z.",
        +[](S& s, Index) -> Plane& { return s.cloth.grid.plane; }, has_grid},
    SceneKey{"cloth.origin", "m", "[0.0, 2.0, 0.0]", scene_rules::vector,
        "Where the top-left particle (0, 0) rests.",
        +[](S& s, Index) -> Vec3d& { return s.cloth.grid.origin; }, has_grid},
    SceneKey{"cloth.mesh", "", "", "path of an OBJ or PLY file",
        "A mesh of triangles and quads instead of the sheet; relative to the scene file.",
        +[](S& s, Index) -> std::string& { return s.cloth.mesh_path; }, has_mesh},

    SceneKey{"material.fabric", "", "\"flag\"", fabric_names,
        "Preset that gives every key of [material] not given here. Where [cloth] is given, the default is \"cotton\".",
        +[](S& s, Index) -> std::string& { return s.material.fabric; }},
    SceneKey{"material.mass_per_area", "kg/m2", "0.12", scene_rules::positive,
        "Each particle gets the area nearest to it. Default: the fabric's.",
        +[](S& s, Index) -> double& { return s.material.mass_per_area; }, has_mass_per_area},
    SceneKey{"material.particle_mass", "kg", "", scene_rules::positive,
        "Gives every particle the same mass, in place of mass_per_area.",
        +[](S& s, Index) -> std::optional<double>& { return s.material.particle_mass; }, has_particle_mass},
    SceneKey{"material.stiffness_per", "", "\"width\"", "\"spring\" or \"width\"",
        "What every stiffness and damping below is counted per: one spring, or a metre of the cloth's width. With \"spring\" the fabric gives the mass only, and a key not given is 0.",
        +[](S& s, Index) -> StiffnessPer& { return s.material.stiffness_per; }},
    SceneKey{"material.structural.stiffness", "N/m", "120.0", scene_rules::not_negative,
        "Springs between neighbours in a row or column; every edge of a mesh. Default: the fabric's.",
        +[](S& s, Index) -> double& { return s.material.structural.stiffness; }},
    SceneKey{"material.structural.damping", "N s/m", "0.012", scene_rules::not_negative,
        "Dashpot along each of these springs. Default: the fabric's.",
        +[](S& s, Index) -> double& { return s.material.structural.damping; }},
    SceneKey{"material.shear.stiffness", "N/m", "40.0", scene_rules::not_negative,
        "Springs along both diagonals of each cell or quad. Default: the fabric's.",
        +[](S& s, Index) -> double& { return s.material.shear.stiffness; }},
    SceneKey{"material.shear.damping", "N s/m", "0.004", scene_rules::not_negative,
        "Dashpot along each of these springs. Default: the fabric's.",
        +[](S& s, Index) -> double& { return s.material.shear.damping; }},
    SceneKey{"material.bend.stiffness", "N/m", "10.0", scene_rules::not_negative,
        "Springs to the particle after the next; on a mesh between the corners facing each other across an edge. Default: the fabric's.",
        +[](S& s, Index) -> double& { return s.material.bend.stiffness; }},
    SceneKey{"material.bend.damping", "N s/m", "0.001", scene_rules::not_negative,
        "Dashpot along each of these springs. Default: the fabric's.",
        +[](S& s, Index) -> double& { return s.material.bend.damping; }},
    SceneKey{"material.bend.layout", "", "\"interior\"", "\"interior\" or \"border\"",
        "Bend springs along every row and column, or along the four border lines of a grid only.",
        +[](S& s, Index) -> BendLayout& { return s.material.bend_layout; }},

    SceneKey{"pins[].select", "", "\"left-edge\"", selectors,
        "Particles held by this pin. Required in each [[pins]]. A box holds rest positions inside it, borders included.",
        +[](S& s, Index pin) -> PinSelector& { return s.pins.at(pin).select; }},
    SceneKey{"pins[].motion", "s, m", "[]", "a list of { time = NUMBER, offset = [x, y, z] }, times rising",
        "Keyframes of the offset from the rest position; between two it eases in and out, before the first and after the last it rests. Empty: the particles do not move.",
        +[](S& s, Index pin) -> std::vector<PinKeyframe>& { return s.pins.at(pin).motion; }},

    SceneKey{"obstacles[].sphere.centre", "m", "[0.0, 0.5, 0.0]", scene_rules::vector,
        "Middle of a ball that the cloth cannot enter. Each [[obstacles]] has a sphere or a plane.",
        +[](S& s, Index i) -> Vec3d& { return sphere(s, i).centre; }, is_sphere},
    SceneKey{"obstacles[].sphere.radius", "m", "0.25", scene_rules::positive,
        "Its radius.",
        +[](S& s, Index i) -> double& { return sphere(s, i).radius; }, is_sphere},
    SceneKey{"obstacles[].plane.point", "m", "[0.0, 0.0, 0.0]", scene_rules::vector,
        "Any point of a plane that the cloth cannot pass.",
        +[](S& s, Index i) -> Vec3d& { return plane(s, i).point; }, is_plane},
    SceneKey{"obstacles[].plane.normal", "", "[0.0, 1.0, 0.0]", scene_rules::normal,
        "Points to the side where the cloth stays; of any length.",
        +[](S& s, Index i) -> Vec3d& { return plane(s, i).normal; }, is_plane},
    SceneKey{"obstacles[].friction", "", "0.4", scene_rules::friction,
        "Coulomb's coefficient of friction between the cloth and this obstacle, at rest and sliding.",
        +[](S& s, Index i) -> double& { return s.obstacles.at(i).friction; }},
    SceneKey{"obstacles[].gap", "m", "0.005", scene_rules::gap,
        "Distance that particles keep from the surface, so that the cloth between them keeps clear of it.",
        +[](S& s, Index i) -> double& { return s.obstacles.at(i).gap; }},

    SceneKey{"start.state", "", "", "path of a NumPy file",
        "Positions [m] and velocities [m/s] of frame 0, in place of the cloth's rest state: little-endian float64 or float32 of shape (2, particles, 3). Relative to the scene file.",
        +[](S& s, Index) -> std::string& { return s.start.state_path; }, has_start_state},
    SceneKey{"start.time", "s", "0.0", scene_rules::not_negative,
        "Time of frame 0, which counts for gusts and for the motion of pins.",
        +[](S& s, Index) -> double& { return s.start.time; }, begins_elsewhere},

    SceneKey{"forces.gravity", "m/s2", "[0.0, -9.81, 0.0]", scene_rules::vector,
        "Acceleration of free fall.",
        +[](S& s, Index) -> Vec3d& { return s.forces.gravity; }},
    SceneKey{"forces.damping", "kg/s", "0.0", scene_rules::not_negative,
        "Drag on every particle, force = -damping * velocity.",
        +[](S& s, Index) -> double& { return s.forces.damping; }},

    SceneKey{"wind.velocity", "m/s", "[4.0, 0.0, 1.4]", scene_rules::vector,
        "Mean wind.",
        +[](S& s, Index) -> Vec3d& { return s.wind.value().velocity; }, has_wind},
    SceneKey{"wind.air_density", "kg/m3", "1.2", scene_rules::not_negative,
        "0 is a vacuum: no air force.",
        +[](S& s, Index) -> double& { return s.wind.value().air_density; }, has_wind},
    SceneKey{"wind.drag", "", "1.0", scene_rules::not_negative,
        "Factor on the force normal to each triangle, that of a flat plate.",
        +[](S& s, Index) -> double& { return s.wind.value().drag; }, has_wind},
    SceneKey{"wind.skin_friction", "", "0.01", scene_rules::not_negative,
        "Coefficient of the force along each triangle.",
        +[](S& s, Index) -> double& { return s.wind.value().skin_friction; }, has_wind},
    SceneKey{"wind.gust", "", "", "\"none\", or a table with model, spread, period, seed",
        "Gusts on top of the mean wind. Where it is not given, the gust has the defaults below.",
        +[](S& s, Index) -> GustModel& { return s.wind.value().gust.model; }, has_no_gust},
    SceneKey{"wind.gust.model", "", "\"coefficient\"", "\"none\" or \"coefficient\"",
        "\"coefficient\": each component of the wind times a random factor of its own.",
        +[](S& s, Index) -> GustModel& { return s.wind.value().gust.model; }, has_gust},
    SceneKey{"wind.gust.spread", "", "0.5", scene_rules::spread,
        "The factors lie between 1 - spread and 1 + spread.",
        +[](S& s, Index) -> double& { return s.wind.value().gust.spread; }, has_gust},
    SceneKey{"wind.gust.period", "s", "0.25", scene_rules::positive,
        "Time between two draws of the factors; they change smoothly in between.",
        +[](S& s, Index) -> double& { return s.wind.value().gust.period; }, has_gust},
    SceneKey{"wind.gust.seed", "", "7", "an integer, 0 or more",
        "The same seed gives the same gusts.",
        +[](S& s, Index) -> std::uint64_t& { return s.wind.value().gust.seed; }, has_gust},

    SceneKey{"integrator.method", "", "\"auto\"", "a method of `weft list integrators`, or \"auto\"",
        "How positions and velocities are advanced by a step. \"auto\": velocity-verlet where its stable steps cost less than an implicit method's, tr-bdf2 where they cost more; among obstacles implicit-euler in its place.",
        +[](S& s, Index) -> std::string& { return s.integrator.method; }},
    SceneKey{"integrator.time_step", "s", "\"auto\"", scene_rules::time_step,
        "Largest step; the step taken divides a frame into a whole number. \"auto\": 0.9 of the largest stable step; where a method has no such limit, the step of `weft list integrators`; where it controls its error, what that allows. Among obstacles at most 1/480 s, or 1/240 s (docs/contact.md).",
        +[](S& s, Index) -> std::optional<double>& { return s.integrator.time_step; }},
    SceneKey{"integrator.precision", "", "\"single\"", "\"single\" or \"double\"",
        "32- or 64-bit floating point.",
        +[](S& s, Index) -> Precision& { return s.integrator.precision; }},
    SceneKey{"integrator.tolerance", "m", "\"auto\"", scene_rules::tolerance,
        "Of methods that control their error (dopri5, bosh3): the largest local error of a position in a step; \"auto\" is 1e-5 m. Of implicit ones: a step is solved when no particle moved farther in the last iteration; \"auto\" is 1/20000 of the cloth's diagonal.",
        +[](S& s, Index) -> std::optional<double>& { return s.integrator.tolerance; }},
    SceneKey{"integrator.iterations", "", "\"auto\"", scene_rules::iterations,
        "Most iterations a step, of methods that iterate.",
        +[](S& s, Index) -> std::optional<int>& { return s.integrator.iterations; }},
    SceneKey{"integrator.linear_solver", "", "\"auto\"", scene_rules::linear_solver,
        "What implicit methods solve their linear systems with. \"auto\": multigrid on a grid, aggregation on a mesh. \"cholesky\" is a direct solver.",
        +[](S& s, Index) -> LinearSolver& { return s.integrator.linear_solver; }},
    SceneKey{"integrator.on_divergence", "", "\"stop\"", "\"stop\" or \"halve-step\"",
        "What to do when the simulation blows up: end with an error, or go on from the last good frame with half the step.",
        +[](S& s, Index) -> OnDivergence& { return s.integrator.on_divergence; }},

    SceneKey{"output.duration", "s", "8.0", scene_rules::not_negative,
        "Simulated time. Frame 0 is the initial state, so 0 records that alone.",
        +[](S& s, Index) -> double& { return s.output.duration; }},
    SceneKey{"output.frames_per_second", "1/s", "30.0", scene_rules::positive,
        "Frames recorded per simulated second.",
        +[](S& s, Index) -> double& { return s.output.frames_per_second; }},
    SceneKey{"output.formats", "", "[\"glb\", \"pc2\", \"mp4\"]", "a list of formats of `weft list formats`, none twice",
        "What to record; [] records nothing.",
        +[](S& s, Index) -> std::vector<std::string>& { return s.output.formats; }},
    SceneKey{"output.energy_balance", "", "false", yes_or_no,
        "Whether to sum up the work of every force over time, for the energy balance in summary.json.",
        +[](S& s, Index) -> bool& { return s.output.energy_balance; }},

    SceneKey{"output.settle", "", "false", yes_or_no,
        "Whether frame 0 is the state of rest, under gravity, the wind at time 0 and the pins' first places, in place of the flat cloth.",
        +[](S& s, Index) -> bool& { return s.output.settle; }},

    SceneKey{"render.size", "pixels", "[1280, 720]", scene_rules::picture_size,
        "Width and height of pictures.",
        +[](S& s, Index) -> std::array<int, 2>& { return s.render.size; }},
    SceneKey{"render.texture", "", "\"flag\"", "\"flag\", \"checker\", \"stripes\", \"linen\", \"plain\", or the path of a PNG or JPEG file",
        "What the cloth looks like; a path is relative to the scene file. Where [cloth] is given, the default is \"linen\".",
        +[](S& s, Index) -> std::string& { return s.render.texture; }},
    SceneKey{"render.mast", "", "true", yes_or_no,
        "Whether a pole stands along the cloth's left edge. Where [cloth] is given, the default is false.",
        +[](S& s, Index) -> bool& { return s.render.mast; }},
    SceneKey{"render.ground", "", "true", yes_or_no,
        "Whether there is a floor that takes the shadow.",
        +[](S& s, Index) -> bool& { return s.render.ground; }},
    SceneKey{"render.camera", "m", "\"auto\"", scene_rules::view_point,
        "Place of the eye. \"auto\": where the whole motion is in the picture.",
        +[](S& s, Index) -> std::optional<Vec3d>& { return s.render.camera; }},
    SceneKey{"render.target", "m", "\"auto\"", scene_rules::view_point,
        "Point in the middle of the picture. \"auto\": the middle of the cloth.",
        +[](S& s, Index) -> std::optional<Vec3d>& { return s.render.target; }},
    SceneKey{"render.field_of_view", "degrees", "35.0", scene_rules::field_of_view,
        "Angle from the lower to the upper border of the picture.",
        +[](S& s, Index) -> double& { return s.render.field_of_view; }},
};
// clang-format on

}  // namespace

std::span<const SceneKey> scene_keys() {
    return table;
}

std::span<const SceneList> scene_lists() {
    return lists;
}

}  // namespace weft
