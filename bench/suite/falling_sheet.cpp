#include "bench/suite/falling_sheet.h"

#include <cmath>

namespace weft::bench {

SceneDescription falling_sheet(int size, std::string_view method) {
    SceneDescription scene;
    scene.name = "Falling sheet";
    scene.cloth.grid = {{1.0, 1.0}, {size, size}, Plane::xz, {0.0, 0.0, 0.0}};
    scene.material.mass_per_area = 0.2;
    scene.material.stiffness_per = StiffnessPer::spring;
    scene.material.structural = {1000.0, 0.0};
    scene.material.shear = {500.0, 0.0};
    scene.material.bend = {100.0, 0.0};
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    scene.wind.reset();
    scene.integrator.method = method;
    scene.integrator.precision = Precision::f64;
    scene.output.frames_per_second = 60.0;
    scene.output.formats.clear();
    return scene;
}

Simulation let_fall(const SceneDescription& scene) {
    constexpr double height = 0.002;  // [m]
    Simulation simulation(scene);
    FrameBuffer buffer;
    simulation.capture(buffer, {.positions = true, .velocities = true});
    for (Vec3d& x : buffer.positions) x.y += height * std::sin(7.0 * x.x) * std::cos(5.0 * x.z);
    simulation.set_state(buffer.positions, buffer.velocities);
    return simulation;
}

}  // namespace weft::bench
