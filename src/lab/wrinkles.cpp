#include "lab/wrinkles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace weft::lab {

Wrinkles::Wrinkles(const Surface& surface) : surface_(&surface) {
    // Edges by the particles they join, so that seams of the texture do not part them.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first;
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::uint32_t a = surface.particle(surface.triangles[t][corner]);
            std::uint32_t b = surface.particle(surface.triangles[t][(corner + 1) % 3]);
            if (a > b) std::swap(a, b);
            const auto [place, is_new] = first.try_emplace({a, b}, t);
            if (!is_new) edges_.push_back({place->second, t});
        }
    }
}

double Wrinkles::angle(std::span<const Vec3d> positions) const {
    std::vector<Vec3d> normals;
    normals.reserve(surface_->triangles.size());
    for (const auto& [a, b, c] : surface_->triangles) {
        const Vec3d origin = positions[surface_->particle(a)];
        normals.push_back(cross(positions[surface_->particle(b)] - origin,
                                positions[surface_->particle(c)] - origin));
    }
    double sum = 0.0;
    std::size_t count = 0;
    for (const auto& [s, t] : edges_) {
        const Vec3d &n = normals[s], &m = normals[t];
        const double angle = std::atan2(length(cross(n, m)), dot(n, m));
        if (!(dot(n, n) > 0.0) || !(dot(m, m) > 0.0)) continue;
        sum += angle * angle;
        ++count;
    }
    if (count == 0) return 0.0;
    return std::sqrt(sum / static_cast<double>(count)) * 180.0 / std::numbers::pi;
}

double Wrinkles::angle(const ClothModel& cloth, const ParticleState<double>& state) const {
    return angle(positions_of(cloth, state));
}

std::vector<Vec3d> positions_of(const ClothModel& cloth, const ParticleState<double>& state) {
    std::vector<Vec3d> positions(cloth.particle_count);
    cloth.layout.for_each(
        [&](std::size_t particle, std::size_t slot) { positions[particle] = state.x[slot]; });
    return positions;
}

}  // namespace weft::lab
