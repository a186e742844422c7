#include "cloth/cloth_model.h"

#include <fmt/format.h>
#include <algorithm>

#include <numeric>

#include "cloth/mesh_order.h"
#include "cloth/pins.h"
#include "weft/error.h"

namespace weft {

Vec3d ClothModel::rest_position(std::size_t particle) const {
    if (!is_grid()) return mesh_positions[particle];
    return grid_position(*grid, particle % shape.columns, particle / shape.columns);
}

std::array<std::size_t, 3> ClothModel::spring_counts() const {
    std::array<std::size_t, 3> counts{};
    for_each_spring([&](const Spring& spring, const SpringConstants&) {
        ++counts[static_cast<std::size_t>(spring.kind)];
    });
    return counts;
}

double ClothModel::total_mass() const {
    return std::reduce(masses.begin(), masses.end());
}

double ClothModel::rest_diagonal() const {
    if (particle_count == 0) return 0.0;
    Vec3d low = rest_position(0), high = low;
    for (std::size_t p = 1; p < particle_count; ++p) {
        const Vec3d x = rest_position(p);
        low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
        high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
    }
    return length(high - low);
}

std::string ClothModel::particle_name(std::size_t particle) const {
    if (!is_grid()) return fmt::format("{}", particle);
    return fmt::format("{} (column {}, row {})", particle, particle % shape.columns,
                       particle / shape.columns);
}

namespace {

void build_grid(const SceneDescription& scene, ClothModel& cloth) {
    cloth.grid = scene.cloth.grid;
    cloth.shape = grid_shape(*cloth.grid);
    cloth.particle_count = cloth.shape.particle_count();
    cloth.layout = ParticleLayout::of_grid(cloth.shape.columns, cloth.shape.rows);
    cloth.families =
        grid_spring_families(cloth.shape, scene.material.stiffness_per, scene.material.bend_layout);
    cloth.surface = grid_surface(cloth.shape);
    cloth.masses.reserve(cloth.particle_count);
    for (std::size_t j = 0; j < cloth.shape.rows; ++j) {
        for (std::size_t i = 0; i < cloth.shape.columns; ++i) {
            cloth.masses.push_back(scene.material.mass_per_area * grid_area(cloth.shape, i, j));
        }
    }
}

void build_mesh(const SceneDescription& scene, ClothModel& cloth) {
    MeshCloth mesh = build_mesh_cloth(*scene.cloth.mesh, scene.cloth.mesh_path);
    cloth.particle_count = mesh.rest_positions.size();
    cloth.mesh_positions = std::move(mesh.rest_positions);
    cloth.springs = std::move(mesh.springs);
    cloth.layout = ParticleLayout::of_slots(mesh_order(cloth.particle_count, cloth.springs));
    cloth.surface = std::move(mesh.surface);
    cloth.report = std::move(mesh.report);
    cloth.masses = std::move(mesh.areas);
    for (double& mass : cloth.masses) mass *= scene.material.mass_per_area;
}

// A particle of no mass has no acceleration: only a mesh whose triangles there have no area.
void check_masses(const SceneDescription& scene, const ClothModel& cloth) {
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        if (!(cloth.masses[p] > 0.0)) {
            throw file_error(scene.cloth.mesh_path,
                             fmt::format("particle {} has no mass: every face around it is without "
                                         "area",
                                         p),
                             "Give the scene material.particle_mass, or mend the mesh.");
        }
    }
}

}  // namespace

ClothModel build_cloth(const SceneDescription& scene) {
    ClothModel cloth;
    cloth.stiffness_per = scene.material.stiffness_per;
    cloth.materials = {scene.material.structural, scene.material.shear, scene.material.bend};
    if (scene.cloth.mesh) {
        build_mesh(scene, cloth);
    } else {
        build_grid(scene, cloth);
    }
    if (scene.material.particle_mass) {
        cloth.masses.assign(cloth.particle_count, *scene.material.particle_mass);
    }
    check_masses(scene, cloth);
    place_pins(scene, cloth);
    return cloth;
}

}  // namespace weft
