// Small cloths and states that the tests of the core share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth/cloth_model.h"
#include "cloth/particle_state.h"
#include "math/random.h"
#include "weft/scene.h"

namespace weft::test {

/// A free sheet in empty space: no pins, no air, no gravity, no damping; plain stiffness per
/// spring, in double.
inline SceneDescription bare_sheet(int columns, int rows, double width = 1.0, double height = 1.0) {
    SceneDescription scene;
    scene.cloth.grid = {{width, height}, {columns, rows}, Plane::xy, {0.0, 0.0, 0.0}};
    scene.material.mass_per_area = 0.2;
    scene.material.stiffness_per = StiffnessPer::spring;
    scene.material.structural = {100.0, 0.0};
    scene.material.shear = {40.0, 0.0};
    scene.material.bend = {5.0, 0.0};
    scene.pins.clear();
    scene.forces = {{0.0, 0.0, 0.0}, 0.0};
    scene.wind.reset();
    scene.integrator.precision = Precision::f64;
    scene.output.formats.clear();
    return scene;
}

/// Gives every spring a dashpot of c = ratio * k.
inline void add_dashpots(SceneDescription& scene, double ratio) {
    for (SpringMaterial* spring :
         {&scene.material.structural, &scene.material.shear, &scene.material.bend}) {
        spring->damping = ratio * spring->stiffness;
    }
}

/// The same sheet as a mesh of quads, particle for particle.
inline void make_mesh_of_grid(SceneDescription& scene) {
    const GridShape shape = grid_shape(scene.cloth.grid);
    auto mesh = std::make_shared<Mesh>();
    for (std::size_t p = 0; p < shape.particle_count(); ++p) {
        mesh->positions.push_back(
            grid_position(scene.cloth.grid, p % shape.columns, p / shape.columns));
    }
    for (const auto& quad : grid_surface(shape).faces) {
        Mesh::Face face;
        face.position = quad;
        face.corners = 4;
        mesh->faces.push_back(face);
    }
    scene.cloth.mesh = mesh;
    scene.cloth.mesh_path = "grid.obj";
}

/// A mesh's particles at other slots, far from in order: neighbours 7 apart, and turned round.
inline void shuffle_layout(ClothModel& mesh) {
    const std::size_t count = mesh.particle_count;
    std::vector<std::uint32_t> slots(count);
    std::uint32_t slot = 0;
    for (std::size_t first = 7; first-- > 0;) {
        for (std::size_t p = first; p < count; p += 7) slots[p] = slot++;
    }
    mesh.layout = ParticleLayout::of_slots(std::move(slots));
}

template <typename Real>
ParticleState<Real> rest_state(const ClothModel& cloth) {
    ParticleState<Real> state{Vec3Array<Real>(cloth.layout.slot_count()),
                              Vec3Array<Real>(cloth.layout.slot_count()), 0.0};
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        state.x.set(cloth.slot(p), vec3_cast<Real>(cloth.rest_position(p)));
    }
    return state;
}

/// Uniform in [-1, 1] in each component, a function of (seed, particle).
inline Vec3d random_vector(std::uint64_t seed, std::size_t particle) {
    const auto component = [&](std::uint64_t n) {
        return 2.0 * random_uniform(seed, n, particle) - 1.0;
    };
    return {component(0), component(1), component(2)};
}

/// Adds random vectors of up to `amplitude` in each component to every particle's of [slot].
template <typename Real>
void disturb(const ClothModel& cloth, Vec3Array<Real>& array, double amplitude,
             std::uint64_t seed) {
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        array.set(slot, array[slot] + vec3_cast<Real>(amplitude * random_vector(seed, p)));
    });
}

/// A state far from rest: places off by a fifth of the cell, speeds of up to 2 m/s.
template <typename Real>
ParticleState<Real> disturbed_state(const ClothModel& cloth, double cell, std::uint64_t seed = 5) {
    ParticleState<Real> state = rest_state<Real>(cloth);
    disturb(cloth, state.x, 0.2 * cell, seed);
    disturb(cloth, state.v, 2.0, seed + 1);
    return state;
}

/// A chain of particles on the x axis joined to their neighbours by structural springs.
inline ClothModel straight_chain(std::size_t particles, double link, double mass, double stiffness,
                                 double damping = 0.0) {
    ClothModel chain;
    chain.particle_count = particles;
    chain.layout = ParticleLayout::in_order(particles);
    chain.surface.particle_count = particles;
    chain.materials[0] = {stiffness, damping};
    chain.masses.assign(particles, mass);
    for (std::size_t p = 0; p < particles; ++p) {
        chain.mesh_positions.push_back({link * static_cast<double>(p), 0.0, 0.0});
        if (p == 0) continue;
        chain.springs.push_back({static_cast<std::uint32_t>(p - 1), static_cast<std::uint32_t>(p),
                                 SpringKind::structural, link, 1.0});
    }
    return chain;
}

inline void pin_at_rest(ClothModel& cloth, std::uint32_t particle) {
    cloth.pins.push_back({particle, Pin::no_motion, cloth.rest_position(particle)});
}

}  // namespace weft::test
