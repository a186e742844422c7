// Grids, states and blocks to try a grid's multigrid solver on, and Newton's matrix from the
// readable products of forces/linearised.h.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "forces/linearised.h"
#include "forces/newton_matrix.h"
#include "support/cloth_forces.h"
#include "weft/instruction_set.h"

namespace weft::test {

inline constexpr double inverse_tau = 60.0;

struct Sheet {
    const char* name;
    ClothModel cloth;
};

/// Dashpots, uneven cells, masses and widths, two pins.
inline SceneDescription damped_scene(int columns, int rows) {
    SceneDescription scene = bare_sheet(columns, rows, 1.0, 0.6);
    add_dashpots(scene, 3e-3);
    scene.material.shear.damping *= 2;
    scene.material.stiffness_per = StiffnessPer::width;
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::bottom_right, {}}};
    return scene;
}

inline constexpr std::array<std::pair<int, int>, 14> sizes{{{2, 2},
                                                            {3, 2},
                                                            {2, 9},
                                                            {5, 3},
                                                            {6, 6},
                                                            {16, 4},
                                                            {17, 5},
                                                            {18, 3},
                                                            {19, 7},
                                                            {31, 33},
                                                            {34, 2},
                                                            {35, 6},
                                                            {50, 37},
                                                            {67, 11}}};

inline std::vector<Sheet> sheets() {
    std::vector<Sheet> result;
    for (const auto& [columns, rows] : sizes) {
        result.push_back({"width", build_cloth(damped_scene(columns, rows))});
    }
    SceneDescription spring = damped_scene(21, 13);
    spring.material.stiffness_per = StiffnessPer::spring;
    result.push_back({"spring", build_cloth(spring)});
    SceneDescription border = damped_scene(23, 9);
    border.material.bend_layout = BendLayout::border;
    result.push_back({"border", build_cloth(border)});
    return result;
}

/// Masses over tau^2; with `air` also blocks a a^T that differ from particle to particle.
inline SymmetricBlocks<double> some_blocks(const ClothModel& cloth, bool air) {
    SymmetricBlocks<double> blocks(cloth.layout.slot_count());
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        const Vec3d a = random_vector(11, p);
        const double mass = cloth.masses[p] * inverse_tau * inverse_tau, f = air ? mass : 0.0;
        const std::array<double, 6> entries{mass + f * a.x * a.x, f * a.x * a.y,
                                            f * a.x * a.z,        mass + f * a.y * a.y,
                                            f * a.y * a.z,        mass + f * a.z * a.z};
        for (std::size_t n = 0; n < 6; ++n) blocks.entries[n][slot] = entries[n];
    });
    for (const Pin& pin : cloth.pins) {  // of no meaning: must not be looked at
        for (auto& entry : blocks.entries) entry[cloth.slot(pin.particle)] = 1e30;
    }
    return blocks;
}

inline std::vector<bool> pinned_slots(const ClothModel& cloth) {
    std::vector<bool> pinned(cloth.layout.slot_count(), true);
    cloth.layout.for_each([&](std::size_t, std::size_t slot) { pinned[slot] = false; });
    for (const Pin& pin : cloth.pins) pinned[cloth.slot(pin.particle)] = true;
    return pinned;
}

/// Random vectors of up to 1 in each component, zero for pinned particles.
template <typename Real>
Vec3Array<Real> random_field(const ClothModel& cloth, std::uint64_t seed) {
    Vec3Array<Real> field(cloth.layout.slot_count());
    disturb(cloth, field, 1.0, seed);
    for (const Pin& pin : cloth.pins) field.set(cloth.slot(pin.particle), {});
    return field;
}

template <typename Real>
double dot_of(const Vec3Array<Real>& a, const Vec3Array<Real>& b) {
    double sum = 0.0;
    for (std::size_t s = 0; s < a.size(); ++s) {
        sum += dot(vec3_cast<double>(a[s]), vec3_cast<double>(b[s]));
    }
    return sum;
}

template <typename Real>
double length_of(const Vec3Array<Real>& a) {
    return std::sqrt(dot_of(a, a));
}

template <typename Real, typename Other>
double distance_of(const Vec3Array<Real>& a, const Vec3Array<Other>& b) {
    double sum = 0.0;
    for (std::size_t s = 0; s < a.size(); ++s) {
        const Vec3d difference = vec3_cast<double>(a[s]) - vec3_cast<double>(b[s]);
        sum += dot(difference, difference);
    }
    return std::sqrt(sum);
}

/// A u in double, by the readable products.
inline Vec3Array<double> expected_product(const ClothModel& cloth, ConstVec3View<double> x,
                                          const SymmetricBlocks<double>& blocks,
                                          const Vec3Array<double>& u) {
    const std::size_t slots = cloth.layout.slot_count();
    Vec3Array<double> stiffness(slots), damping(slots), product(slots);
    stiffness_product(cloth, x, u.view(), stiffness.view());
    damping_product(cloth, ForcesDescription{{}, 0.0}, x, u.view(), damping.view());
    const std::vector<bool> pinned = pinned_slots(cloth);
    const auto& [xx, xy, xz, yy, yz, zz] = blocks.entries;
    for (std::size_t s = 0; s < slots; ++s) {
        if (pinned[s]) continue;
        const Vec3d v = u[s];
        const Vec3d b{xx[s] * v.x + xy[s] * v.y + xz[s] * v.z,
                      xy[s] * v.x + yy[s] * v.y + yz[s] * v.z,
                      xz[s] * v.x + yz[s] * v.y + zz[s] * v.z};
        product.set(s, b + stiffness[s] + inverse_tau * damping[s]);
    }
    return product;
}

/// A as a dense matrix over slots, with the identity where nothing is free.
inline Eigen::MatrixXd dense_matrix(const ClothModel& cloth, ConstVec3View<double> x,
                                    const SymmetricBlocks<double>& blocks) {
    const std::size_t slots = cloth.layout.slot_count();
    const std::vector<bool> pinned = pinned_slots(cloth);
    const auto size = static_cast<Eigen::Index>(3 * slots);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
    for (std::size_t n = 0; n < 3 * slots; ++n) {
        if (pinned[n / 3]) continue;
        Vec3Array<double> u(slots);
        u.set(n / 3, {n % 3 == 0 ? 1.0 : 0.0, n % 3 == 1 ? 1.0 : 0.0, n % 3 == 2 ? 1.0 : 0.0});
        const Vec3Array<double> column = expected_product(cloth, x, blocks, u);
        for (std::size_t m = 0; m < slots; ++m) {
            const Vec3d entry = column[m];
            matrix.col(static_cast<Eigen::Index>(n)).segment<3>(static_cast<Eigen::Index>(3 * m))
                << entry.x,
                entry.y, entry.z;
        }
    }
    return matrix;
}

inline Eigen::VectorXd as_dense(const Vec3Array<double>& field) {
    Eigen::VectorXd vector(static_cast<Eigen::Index>(3 * field.size()));
    for (std::size_t s = 0; s < field.size(); ++s) {
        vector.segment<3>(static_cast<Eigen::Index>(3 * s)) << field[s].x, field[s].y, field[s].z;
    }
    return vector;
}

inline std::vector<InstructionSet> all_sets() {
    std::vector<InstructionSet> sets;
    for (std::size_t n = 0; n < instruction_sets().size(); ++n) {
        sets.push_back(static_cast<InstructionSet>(n));
    }
    return sets;
}

/// A state with compressed springs, one of no length, far from the origin.
inline Vec3Array<double> some_positions(const ClothModel& cloth) {
    Vec3Array<double> x = disturbed_state<double>(cloth, 0.05).x;
    x.set(cloth.slot(1), x[cloth.slot(2)]);
    cloth.layout.for_each([&](std::size_t, std::size_t slot) {
        x.set(slot, x[slot] + Vec3d{100.0, -40.0, 7.0});
    });
    return x;
}

}  // namespace weft::test
