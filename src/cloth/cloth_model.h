// A cloth as the engine sees it: what never changes in a step.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cloth/grid_cloth.h"
#include "cloth/mesh_cloth.h"
#include "cloth/particle_layout.h"
#include "cloth/springs.h"
#include "weft/frame.h"
#include "weft/scene.h"

namespace weft {

/// Stiffness and dashpot of one spring, its width factor applied.
struct SpringConstants {
    double stiffness = 0.0;  ///< k [N/m]
    double damping = 0.0;    ///< c [N s/m]
};

/// A particle that does not move by itself.
struct Pin {
    std::uint32_t particle = 0;
    std::uint32_t motion = 0;  ///< index into ClothModel::motions; no_motion: it rests
    Vec3d rest{};              ///< [m]

    static constexpr std::uint32_t no_motion = 0xffffffff;
};

/// All by particle, as the user numbers them; states and forces stand by slot of the layout.
struct ClothModel {
    std::size_t particle_count = 0;
    ParticleLayout layout;                      ///< of the arrays of states and forces
    std::optional<GridDescription> grid;        ///< given for grids only
    GridShape shape;                            ///< grids only
    GridSpringFamilies families{};              ///< grids only
    std::vector<Spring> springs;                ///< meshes only
    std::array<SpringMaterial, 3> materials{};  ///< by SpringKind
    StiffnessPer stiffness_per = StiffnessPer::spring;
    std::vector<Vec3d> mesh_positions;  ///< [particle], meshes only [m]
    std::vector<double> masses;         ///< [particle] [kg]
    std::vector<Pin> pins;              ///< rising particle number, each once
    std::vector<std::vector<PinKeyframe>> motions;
    Surface surface;
    MeshReport report;  ///< meshes only

    [[nodiscard]] bool is_grid() const { return grid.has_value(); }

    /// Where a particle stands in the arrays of states and forces.
    [[nodiscard]] std::size_t slot(std::size_t particle) const { return layout.slot(particle); }

    /// Where a particle starts [m].
    [[nodiscard]] Vec3d rest_position(std::size_t particle) const;

    /// How many springs of each kind there are, by SpringKind.
    [[nodiscard]] std::array<std::size_t, 3> spring_counts() const;

    [[nodiscard]] double total_mass() const;  ///< [kg]

    /// Diagonal of the box around the cloth as it starts [m].
    [[nodiscard]] double rest_diagonal() const;

    /// "12 (column 12, row 0)" on a grid, "12" on a mesh.
    [[nodiscard]] std::string particle_name(std::size_t particle) const;

    /// Calls visit(const Spring&, const SpringConstants&) for every spring, in one fixed order.
    template <typename Visit>
    void for_each_spring(const Visit& visit) const {
        for_each_spring_with_slots([&](const Spring& spring, const SpringConstants& constants,
                                       std::size_t, std::size_t) { visit(spring, constants); });
    }

    /// The same in the same order, with the slots of the spring's particles p and q:
    /// visit(const Spring&, const SpringConstants&, std::size_t slot_p, std::size_t slot_q).
    template <typename Visit>
    void for_each_spring_with_slots(const Visit& visit) const;

private:
    [[nodiscard]] SpringConstants constants(const Spring& spring) const {
        const SpringMaterial& material = materials[static_cast<std::size_t>(spring.kind)];
        return {material.stiffness * spring.width_factor, material.damping * spring.width_factor};
    }
};

/// Builds the cloth of a scene that check_scene() accepts.
/// @throws Error (usage) for pins that select nothing, are out of range, or contradict each other;
///         Error (file) for a mesh that cannot be a cloth.
ClothModel build_cloth(const SceneDescription& scene);

/// Offset of a pin's motion at time t, and its velocity.
struct PinOffset {
    Vec3d offset{};        ///< [m]
    Vec3d velocity{};      ///< [m/s]
    Vec3d acceleration{};  ///< [m/s2]
};
PinOffset pin_offset(const std::vector<PinKeyframe>& motion, double time);

template <typename Visit>
void ClothModel::for_each_spring_with_slots(const Visit& visit) const {
    for (const Spring& spring : springs) {
        Spring scaled = spring;
        if (stiffness_per == StiffnessPer::spring) scaled.width_factor = 1.0;
        visit(scaled, constants(scaled), slot(scaled.p), slot(scaled.q));
    }
    for (const GridSpringFamily& family : families) {
        for (std::size_t j = 0; j < family.owner_rows; ++j) {
            for (std::size_t i = 0; i < family.owner_columns; ++i) {
                const double factor = family.spring_factor(i, j, shape);
                if (factor == 0.0) continue;
                const auto a = static_cast<std::uint32_t>(shape.index(i + family.ai, j));
                const auto b =
                    static_cast<std::uint32_t>(shape.index(i + family.bi, j + family.bj));
                const Spring spring{a, b, family.kind, family.rest_length, factor};
                const std::size_t owner = j * layout.row_stride() + i;
                visit(spring, constants(spring), owner + family.ai,
                      owner + family.bj * layout.row_stride() + family.bi);
            }
        }
    }
}

}  // namespace weft
