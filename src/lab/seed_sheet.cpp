#include "lab/seed_sheet.h"

#include <fmt/format.h>

namespace weft::lab {

namespace {

constexpr int particles_a_side = 40;
constexpr double side = 20.0;     // [m]
constexpr double gravity = 9.81;  // [m/s2]

}  // namespace

SceneDescription seed_scene(const SeedSheet& sheet) {
    SceneDescription scene;
    scene.name = "The comparison's sheet";
    scene.stem = "sheet";
    scene.cloth.grid = {{side, side},
                        {particles_a_side, particles_a_side},
                        Plane::xz,
                        {-side / 2.0, 36.0, 0.0}};  // high enough to swing clear of the ground
    scene.material.particle_mass = sheet.particle_mass;
    scene.material.stiffness_per = StiffnessPer::spring;
    const SpringMaterial spring{seed_stiffness, sheet.dashpot_time * seed_stiffness};
    scene.material.structural = scene.material.shear = scene.material.bend = spring;
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    scene.forces = {{0.0, -gravity, 0.0}, sheet.drag_rate * sheet.particle_mass};
    scene.wind.reset();
    scene.integrator.precision = Precision::f64;
    scene.render.texture = "checker";
    scene.render.mast = false;
    return scene;
}

double fall_energy(const SeedSheet& sheet) {
    return particles_a_side * particles_a_side * sheet.particle_mass * gravity * side / 2.0;
}

std::string describe(const SeedSheet& sheet) {
    std::string text = fmt::format("{:.4g} kg", sheet.particle_mass);
    if (sheet.drag_rate == 0.0 && sheet.dashpot_time == 0.0) return text + ", undamped";
    if (sheet.drag_rate != 0.0) text += fmt::format(", drag {:.4g} /s", sheet.drag_rate);
    if (sheet.dashpot_time != 0.0) {
        text += fmt::format(", dashpots c = {:.4g} ms k", 1e3 * sheet.dashpot_time);
    }
    return text;
}

}  // namespace weft::lab
