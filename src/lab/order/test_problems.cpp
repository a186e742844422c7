#include "lab/order/test_problems.h"

#include <cmath>

namespace weft::lab {

namespace {

constexpr double gravity = 9.81;  // [m/s2]

SceneDescription bare_scene(int columns, int rows, std::array<double, 2> size) {
    SceneDescription scene;
    scene.cloth.grid = {size, {columns, rows}, Plane::xy, {0.0, 0.0, 0.0}};
    scene.material.stiffness_per = StiffnessPer::spring;
    scene.material.structural = scene.material.shear = scene.material.bend = {0.0, 0.0};
    scene.pins.clear();
    scene.forces = {{0.0, -gravity, 0.0}, 0.0};
    scene.wind.reset();
    scene.integrator.precision = Precision::f64;
    scene.integrator.linear_solver = LinearSolver::jacobi;
    return scene;
}

}  // namespace

SceneDescription hanging_masses() {
    SceneDescription scene = bare_scene(2, 3, {1.0, 1.0});
    scene.material.particle_mass = 1.0;
    scene.material.bend.stiffness = hanging_omega * hanging_omega;
    scene.pins = {{ParticleSelection{{0, 1, 2, 3}}, {}}};
    return scene;
}

ParticleState<double> hanging_solution(const Specimen& hanging_masses, double time) {
    ParticleState<double> state = hanging_masses.start();
    const double phase = hanging_omega * time;
    const double amplitude = gravity / (hanging_omega * hanging_omega);
    for (const std::size_t particle : {4u, 5u}) {
        const std::size_t slot = hanging_masses.cloth().slot(particle);
        state.x.set(slot, state.x[slot] - Vec3d{0.0, amplitude * (1.0 - std::cos(phase)), 0.0});
        state.v.set(slot, {0.0, -amplitude * hanging_omega * std::sin(phase), 0.0});
    }
    state.time = time;
    return state;
}

SceneDescription moving_sheet(bool damped) {
    constexpr std::size_t held = 0, moved = 5;
    SceneDescription scene = bare_scene(6, 6, {1.0, 1.0});
    scene.material.mass_per_area = 2.0;
    scene.material.structural.stiffness = 120.0;
    scene.material.shear.stiffness = 50.0;
    scene.material.bend.stiffness = 10.0;
    scene.forces.gravity = {0.5, -gravity, 1.0};
    scene.pins = {{ParticleSelection{{held}}, {}},
                  {ParticleSelection{{moved}}, {{0.0, {}}, {1.0, {0.3, 0.1, -0.2}}}}};
    if (!damped) return scene;
    scene.forces.damping = 0.02;
    for (SpringMaterial* spring :
         {&scene.material.structural, &scene.material.shear, &scene.material.bend}) {
        spring->damping = 0.01 * spring->stiffness;
    }
    scene.wind = WindDescription{};
    scene.wind->air_density = 0.3;
    scene.wind->velocity = {3.0, 1.5, 8.0};
    scene.wind->gust.period = 5.0;
    return scene;
}

}  // namespace weft::lab
