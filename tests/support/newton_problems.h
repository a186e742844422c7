// Newton's matrix on small sheets, and its products by the readable functions.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "forces/linearised.h"
#include "forces/newton_matrix.h"
#include "support/mesh_scenes.h"

namespace weft::test {

inline constexpr double inverse_tau = 60.0;

inline SceneDescription material_of(SceneDescription scene) {
    scene.material.structural = {1000.0, 0.4};
    scene.material.shear = {500.0, 0.2};
    scene.material.bend = {100.0, 0.0};
    return scene;
}

struct NewtonSheet {
    std::string name;
    ClothModel cloth;
};

// Two corners of a grid, or particles of a mesh, are pinned where `pinned`.
inline NewtonSheet grid_sheet(int columns, int rows, bool pinned) {
    SceneDescription scene = material_of(bare_sheet(columns, rows));
    if (pinned) scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    return {"grid " + std::to_string(columns), build_cloth(scene)};
}

inline NewtonSheet mesh_sheet(Mesh mesh, std::string name, bool pinned) {
    shuffle(mesh, 3);
    NewtonSheet sheet{std::move(name), build_cloth(material_of(mesh_scene(std::move(mesh))))};
    if (pinned) {
        for (const std::uint32_t p : {0u, 5u}) pin_at_rest(sheet.cloth, p);
    }
    return sheet;
}

inline std::vector<NewtonSheet> small_sheets() {
    std::vector<NewtonSheet> sheets;
    for (const bool pinned : {false, true}) {
        sheets.push_back(grid_sheet(2, 2, pinned));
        sheets.push_back(grid_sheet(9, 7, pinned));
        sheets.push_back(grid_sheet(17, 5, pinned));
        sheets.push_back(mesh_sheet(sheet_mesh(8, 9, 0.1, true), "triangles", pinned));
        sheets.push_back(mesh_sheet(sheet_mesh(7, 6, 0.1, false), "quads", pinned));
        sheets.push_back(mesh_sheet(tube_mesh(11, 5, 0.1), "tube", pinned));
    }
    return sheets;
}

// A sheet in folds, partly stretched, partly compressed; and what Newton's matrix is made of.
struct NewtonProblem {
    const ClothModel& cloth;
    ParticleState<double> state;
    SymmetricBlocks<double> blocks;
    Vec3Array<double> r, d;

    explicit NewtonProblem(const ClothModel& its_cloth, double own = 1.0)
        : cloth(its_cloth),
          state(rest_state<double>(cloth)),
          blocks(cloth.layout.slot_count()),
          r(cloth.layout.slot_count()),
          d(cloth.layout.slot_count()) {
        cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
            const Vec3d q = cloth.rest_position(p);
            state.x.set(slot, {0.97 * q.x, 1.02 * q.y, q.z + 0.03 * std::sin(25 * q.x + 6 * q.y)});
            const double m = own * cloth.masses[p] * inverse_tau * inverse_tau;
            const std::array<double, 6> block{1.2 * m, 0.1 * m, 0.0, m, -0.2 * m, 1.5 * m};
            for (std::size_t n = 0; n < 6; ++n) blocks.entries[n][slot] = block[n];
        });
        disturb(cloth, state.x, 2e-4, 4);
        disturb(cloth, r, 1.0, 8);
    }
    [[nodiscard]] ConstVec3View<double> x() const { return std::as_const(state.x).view(); }
    [[nodiscard]] ConstVec3View<double> right() const { return std::as_const(r).view(); }
};

inline std::vector<char> free_slots(const ClothModel& cloth) {
    std::vector<char> free(cloth.layout.slot_count(), 0);
    cloth.layout.for_each([&](std::size_t, std::size_t slot) { free[slot] = 1; });
    for (const Pin& pin : cloth.pins) free[cloth.slot(pin.particle)] = 0;
    return free;
}

// A u by the readable products; zero where pinned.
inline Vec3Array<double> product(const NewtonProblem& problem, const Vec3Array<double>& u) {
    const std::size_t slots = u.size();
    Vec3Array<double> out(slots), damping(slots);
    stiffness_product<double>(problem.cloth, problem.x(), u.view(), out.view());
    damping_product<double>(problem.cloth, ForcesDescription{{}, 0.0}, problem.x(), u.view(),
                            damping.view());
    const std::vector<char> free = free_slots(problem.cloth);
    const auto& [xx, xy, xz, yy, yz, zz] = problem.blocks.entries;
    for (std::size_t s = 0; s < slots; ++s) {
        const Vec3d v = u[s];
        const Vec3d own{xx[s] * v.x + xy[s] * v.y + xz[s] * v.z,
                        xy[s] * v.x + yy[s] * v.y + yz[s] * v.z,
                        xz[s] * v.x + yz[s] * v.y + zz[s] * v.z};
        out.set(s, free[s] != 0 ? out[s] + own + inverse_tau * damping[s] : Vec3d{});
    }
    return out;
}

inline double norm(const Vec3Array<double>& a) {
    double sum = 0.0;
    for (std::size_t s = 0; s < a.size(); ++s) sum += dot(a[s], a[s]);
    return std::sqrt(sum);
}

inline Vec3Array<double> difference(const Vec3Array<double>& a, const Vec3Array<double>& b) {
    Vec3Array<double> result(a.size());
    for (std::size_t s = 0; s < a.size(); ++s) result.set(s, a[s] - b[s]);
    return result;
}

inline Vec3Array<double> masked(const NewtonProblem& problem, Vec3Array<double> a) {
    const std::vector<char> free = free_slots(problem.cloth);
    for (std::size_t s = 0; s < a.size(); ++s) {
        if (free[s] == 0) a.set(s, {});
    }
    return a;
}

// |r - A d| / |r|
inline double residual_of(const NewtonProblem& problem) {
    const Vec3Array<double> r = masked(problem, problem.r);
    return norm(difference(r, product(problem, problem.d))) / norm(r);
}

}  // namespace weft::test
