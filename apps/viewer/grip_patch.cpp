#include "viewer/grip_patch.h"

#include <cassert>
#include <cmath>

namespace weft::viewer {

namespace {

// Stretched by the patch's radius, the springs together carry this many weights of the cloth.
constexpr double weights_per_radius = 30.0;
constexpr double gravity = 9.81;  // [m/s2]; of the weight that is meant, whatever the scene's is

}  // namespace

GripPatch::GripPatch(std::span<const Vec3d> positions, std::size_t particle, Vec3d grabbed_at,
                     double radius, double mass)
    : grabbed_at_(grabbed_at) {
    assert(particle < positions.size() && radius > 0.0);
    double weights = 0.0;
    for (std::size_t p = 0; p < positions.size(); ++p) {
        const double part = length(positions[p] - positions[particle]) / radius;
        if (!(part < 1.0) && p != particle) continue;
        const double weight = p == particle ? 1.0 : (1.0 - part * part) * (1.0 - part * part);
        weights += weight;
        at_start_.push_back({p, positions[p], weight, 0.0});
    }
    const double stiffness = weights_per_radius * mass * gravity / radius;
    // Critical for the whole cloth hanging on the springs: the hand's jerks do not make it swing.
    const double damping = 2.0 * std::sqrt(stiffness * mass);
    for (Grip& grip : at_start_) {
        const double share = grip.stiffness / weights;
        grip.stiffness = share * stiffness;
        grip.damping = share * damping;
    }
}

std::vector<Grip> GripPatch::grips(Vec3d hand) const {
    std::vector<Grip> moved = at_start_;
    for (Grip& grip : moved) grip.point += hand - grabbed_at_;
    return moved;
}

}  // namespace weft::viewer
