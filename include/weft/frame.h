// What a picture or a recording is made of: a surface that stays, and frames that pass.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/vec3.h"

namespace weft {

/// The drawn surface of a cloth; constant during a run. Vertices are particles, save that a mesh
/// doubles a particle where texture co-ordinates part (a seam).
struct Surface {
    static constexpr std::uint32_t no_vertex = 0xffffffff;

    std::size_t particle_count = 0;
    std::vector<std::uint32_t> vertex_particle;           ///< [vertex]; empty: vertex = particle
    std::vector<std::array<float, 2>> uvs;                ///< [vertex], v upward
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertices, counter-clockwise in front
    std::vector<std::array<std::uint32_t, 4>> faces;  ///< quads, or triangles ending in no_vertex

    [[nodiscard]] std::size_t vertex_count() const { return uvs.size(); }
    [[nodiscard]] std::uint32_t particle(std::uint32_t vertex) const {
        return vertex_particle.empty() ? vertex : vertex_particle[vertex];
    }
};

/// The cloth at one moment: a view, valid as long as its owner says. Frame 0 is the initial state.
struct Frame {
    std::size_t index = 0;
    double time = 0.0;                           ///< [s]
    std::span<const Vec3d> positions;            ///< [particle], [m]
    std::span<const Vec3d> velocities;           ///< [particle], [m/s]
    std::span<const Vec3f> normals;              ///< [particle], unit or zero
    std::span<const Vec3f> rounded_positions{};  ///< [particle], the positions in float [m]
};

/// What a frame's taker looks at. Spans that nobody asked for are empty.
struct FrameNeeds {
    bool positions = true;
    bool velocities = true;
    bool normals = true;
    bool rounded_positions = false;

    friend constexpr FrameNeeds operator|(FrameNeeds a, FrameNeeds b) {
        return {a.positions || b.positions, a.velocities || b.velocities, a.normals || b.normals,
                a.rounded_positions || b.rounded_positions};
    }
};

/// Vertex normals: the sum of the cross products of the triangles around each particle (so weighted
/// by area), normalised; zero where that sum is zero.
/// @param normals [particle], overwritten.
void compute_normals(const Surface& surface, std::span<const Vec3d> positions,
                     std::span<Vec3f> normals);

/// Storage of one frame, reused from frame to frame.
struct FrameBuffer {
    std::size_t index = 0;
    double time = 0.0;                         ///< [s]
    std::vector<Vec3d> positions, velocities;  ///< [particle], [m], [m/s]; see FrameNeeds
    std::vector<Vec3f> normals;                ///< [particle]; see FrameNeeds
    std::vector<Vec3f> rounded_positions;      ///< [particle], [m]; see FrameNeeds

    [[nodiscard]] Frame view() const {
        return {index, time, positions, velocities, normals, rounded_positions};
    }
};

}  // namespace weft
