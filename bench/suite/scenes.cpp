#include "bench/suite/scenes.h"

#include <numeric>
#include <random>
#include <utility>

namespace weft::bench {

namespace {

// Of the shipped flag at up to 256 x 256: its stable step there is above twice this [s].
constexpr double flag_step = 1e-5;

void set_stepping(SceneDescription& scene, const Stepping& stepping, double step) {
    scene.integrator.method = stepping.method;
    scene.integrator.precision = stepping.precision;
    scene.integrator.time_step = step;
    scene.output.frames_per_second = 1.0 / (step * stepping.steps_per_frame);
    scene.output.formats.clear();
}

// 0 ... count - 1 in random order; written out, as std::shuffle differs between libraries.
std::vector<std::uint32_t> random_order(std::size_t count, std::mt19937_64& random) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t n = count; n > 1; --n) std::swap(order[n - 1], order[random() % n]);
    return order;
}

}  // namespace

SceneDescription sheet_scene(const PlainSheet& sheet, const Stepping& stepping) {
    SceneDescription scene;
    scene.name = "Plain sheet";
    scene.cloth.grid = {{sheet.cell * (sheet.columns - 1), sheet.cell * (sheet.rows - 1)},
                        {sheet.columns, sheet.rows},
                        Plane::xy,
                        {0.0, 0.0, 0.0}};
    scene.material.particle_mass = sheet.mass;
    scene.material.stiffness_per = StiffnessPer::spring;
    scene.material.structural = {sheet.structural.stiffness, sheet.structural.damping};
    scene.material.shear = {sheet.shear.stiffness, sheet.shear.damping};
    scene.material.bend = {sheet.bend.stiffness, sheet.bend.damping};
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    scene.forces = {sheet.gravity, sheet.drag};
    scene.wind.reset();
    set_stepping(scene, stepping, sheet_step);
    return scene;
}

SceneDescription sheet_at_60_hertz(const PlainSheet& sheet, std::string_view method,
                                   std::optional<double> time_step) {
    SceneDescription scene = sheet_scene(sheet, {.method = method});
    scene.integrator.time_step = time_step;
    scene.output.frames_per_second = 60.0;
    return scene;
}

PlainSheet hanging_sheet(int size) {
    constexpr double drag_rate = 10.0;  // [1/s]
    PlainSheet sheet{.columns = size, .rows = size};
    sheet.cell = 1.0 / (size - 1);
    sheet.mass = 0.2 / (static_cast<double>(size) * size);
    sheet.structural = sheet.shear = {1000.0, 0.0};
    sheet.bend = {1.0, 0.0};
    sheet.drag = drag_rate * sheet.mass;
    return sheet;
}

SceneDescription mesh_scene(const PlainSheet& sheet, const Stepping& stepping, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const std::vector<std::uint32_t> vertices = random_order(sheet.particle_count(), random);
    const auto mesh = std::make_shared<Mesh>();
    mesh->positions.resize(sheet.particle_count());
    const auto columns = static_cast<std::size_t>(sheet.columns);
    for (std::size_t p = 0; p < sheet.particle_count(); ++p) {
        mesh->positions[vertices[p]] =
            sheet.rest_position(static_cast<int>(p % columns), static_cast<int>(p / columns));
    }
    const std::size_t cells = (columns - 1) * static_cast<std::size_t>(sheet.rows - 1);
    for (const std::size_t cell : random_order(cells, random)) {
        const std::size_t corner = cell / (columns - 1) * columns + cell % (columns - 1);
        Mesh::Face face;
        face.corners = 4;
        face.position = {vertices[corner], vertices[corner + columns],
                         vertices[corner + columns + 1], vertices[corner + 1]};
        mesh->faces.push_back(face);
    }
    SceneDescription scene = sheet_scene(sheet, stepping);
    scene.cloth.mesh = mesh;
    scene.cloth.mesh_path = "the sheet in random order";
    scene.pins = {{ParticleSelection{{vertices[0], vertices[columns - 1]}}, {}}};
    return scene;
}

SceneDescription flag_scene(int columns, int rows, bool wind, const Stepping& stepping) {
    SceneDescription scene;
    scene.cloth.grid.resolution = {columns, rows};
    if (!wind) scene.wind.reset();
    set_stepping(scene, stepping, flag_step);
    return scene;
}

}  // namespace weft::bench
