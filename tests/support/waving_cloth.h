// Cloths that wave by formula: known positions, velocities and times for tests of recordings.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "weft/frame.h"

namespace weft::test {

/// A surface whose particles move as q(t) = rest + (0, 0, 0.3) x sin(4 x - 6 t) + (0, 0.1, 0) t.
class WavingCloth {
public:
    Surface surface;
    std::vector<Vec3d> rest;  ///< [particle], [m]
    double frames_per_second = 30.0;
    bool single = true;  ///< positions are rounded to float, as a float run has them

    /// The frame `index`; valid until the next call.
    Frame frame(std::size_t index) {
        const double t = static_cast<double>(index) / frames_per_second;
        positions_.clear();
        velocities_.clear();
        for (const Vec3d& q : rest) {
            const double phase = 4.0 * q.x - 6.0 * t;
            positions_.push_back(rounded(q + Vec3d{0.0, 0.1 * t, 0.3 * q.x * std::sin(phase)}));
            velocities_.push_back(rounded({0.0, 0.1, -1.8 * q.x * std::cos(phase)}));
        }
        normals_.resize(rest.size());
        compute_normals(surface, positions_, normals_);
        return {index, t, positions_, velocities_, normals_};
    }

private:
    [[nodiscard]] Vec3d rounded(Vec3d v) const {
        return single ? vec3_cast<double>(vec3_cast<float>(v)) : v;
    }

    std::vector<Vec3d> positions_, velocities_;
    std::vector<Vec3f> normals_;
};

inline void add_quad(Surface& surface, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                     std::uint32_t d) {
    surface.faces.push_back({a, b, c, d});
    surface.triangles.push_back({a, b, c});
    surface.triangles.push_back({a, c, d});
}

/// A hanging grid of columns x rows particles, 1.5 m wide and 1 m high, top left at (0, 2, 0).
inline WavingCloth waving_grid(std::uint32_t columns, std::uint32_t rows) {
    WavingCloth cloth;
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const double u = i / (columns - 1.0), v = j / (rows - 1.0);
            cloth.rest.push_back({1.5 * u, 2.0 - v, 0.0});
            cloth.surface.uvs.push_back({static_cast<float>(u), static_cast<float>(1.0 - v)});
        }
    for (std::uint32_t j = 0; j + 1 < rows; ++j)
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = j * columns + i;
            add_quad(cloth.surface, a, a + columns, a + columns + 1, a + 1);
        }
    cloth.surface.particle_count = cloth.rest.size();
    return cloth;
}

/// A sleeve of `around` x `along` particles, 0.2 m in radius, along x from 0.5 m on. Where it
/// closes, a column of vertices is doubled (texture seam); its first ring of faces is cut into
/// triangles.
inline WavingCloth waving_sleeve(std::uint32_t around, std::uint32_t along) {
    WavingCloth cloth;
    Surface& surface = cloth.surface;
    for (std::uint32_t j = 0; j < along; ++j)
        for (std::uint32_t i = 0; i < around; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / around;
            cloth.rest.push_back(
                {0.5 + 0.1 * j, 1.0 + 0.2 * std::cos(angle), 0.2 * std::sin(angle)});
        }
    for (std::uint32_t j = 0; j < along; ++j)
        for (std::uint32_t i = 0; i <= around; ++i) {
            surface.vertex_particle.push_back(j * around + i % around);
            surface.uvs.push_back({static_cast<float>(i) / static_cast<float>(around),
                                   static_cast<float>(j) / static_cast<float>(along - 1)});
        }
    for (std::uint32_t j = 0; j + 1 < along; ++j)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = j * (around + 1) + i, b = a + around + 1;
            add_quad(surface, a, a + 1, b + 1, b);
            if (j > 0) continue;
            surface.faces.back() = {a, a + 1, b + 1, Surface::no_vertex};
            surface.faces.push_back({a, b + 1, b, Surface::no_vertex});
        }
    surface.particle_count = cloth.rest.size();
    cloth.single = false;
    return cloth;
}

}  // namespace weft::test
