// The lists of lines and points that an Overlay draws, from what is to be shown. No OpenGL.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/overlay.h"
#include "weft/frame.h"

namespace weft {

/// A spring as it is drawn.
struct DrawnSpring {
    std::uint32_t p = 0, q = 0;  ///< particles
    float rest_length = 0.0F;    ///< [m]
    std::uint8_t kind = 0;       ///< 0 structural, 1 shear, 2 bend
};

/// Which kinds of springs are drawn.
struct SpringKinds {
    bool structural = true, shear = true, bend = true;
};

/// Every function appends to `lines` (two vertices each) or `points`.
using OverlayList = std::vector<OverlayVertex>;

/// Edges of the faces, each once. @param edges of edges_of(surface).
void add_wireframe(std::span<const std::array<std::uint32_t, 2>> edges, const Frame& frame,
                   OverlayList& lines);
/// Edges of the surface's faces as particles, each once, by rising particle.
std::vector<std::array<std::uint32_t, 2>> edges_of(const Surface& surface);

/// Blue for compressed, white at rest, red for stretched; full colour at `strain_range`.
void add_springs_by_strain(std::span<const DrawnSpring> springs, SpringKinds kinds,
                           const Frame& frame, float strain_range, OverlayList& lines);
void add_springs_by_kind(std::span<const DrawnSpring> springs, SpringKinds kinds,
                         const Frame& frame, OverlayList& lines);
/// The colours of the two, for legends: sRGB and opacity.
std::array<std::uint8_t, 4> colour_of_strain(float strain, float strain_range);
std::array<std::uint8_t, 4> colour_of_kind(std::uint8_t kind);

void add_particles(const Frame& frame, OverlayList& points);
/// @param length of a line [m].
void add_normals(const Frame& frame, float length, OverlayList& lines);
/// Marks of pinned particles.
void add_pins(std::span<const std::uint32_t> pinned, const Frame& frame, OverlayList& points);
/// Arrows on a lattice around the box, each `velocity` times `seconds` long.
void add_wind(const Box& around, glm::vec3 velocity, float seconds, OverlayList& lines);
/// An arrow with a head that can be seen from every side.
void add_arrow(glm::vec3 from, glm::vec3 to, std::array<std::uint8_t, 4> colour,
               OverlayList& lines);

}  // namespace weft
