#include "forces/air_damping.h"

#include <cmath>

namespace weft {

std::array<double, 6> plate_damping_third(const AirConstants<double>& air,
                                          Vec3<double> relative_wind, Vec3<double> normal) {
    const double twice_area = length(normal), speed = length(relative_wind);
    if (!(twice_area > 0.0) || !(speed > 0.0)) return {};
    const Vec3d n = normal / twice_area;
    const double v_n = dot(relative_wind, n), v_n2 = v_n * v_n, speed2 = speed * speed;
    const double resistance = 0.222 * std::abs(v_n) + 0.283 * speed;
    const double lost = (0.222 * std::abs(v_n) * speed2 + 0.283 * speed * v_n2) / resistance;
    const double across = air.normal * twice_area * (2.0 * v_n2 + speed2 - lost) / resistance;
    const Vec3d v_t = relative_wind - v_n * n;
    const double slip = length(v_t);
    const Vec3d t = slip > 0.0 ? v_t / slip : Vec3d{};
    const double along = air.tangential * twice_area * slip;
    // across n n^T + along (I - n n^T + t t^T)
    const auto entry = [&](double identity, double n_ab, double t_ab) {
        return (across * n_ab + along * (identity - n_ab + t_ab)) / 3.0;
    };
    return {entry(1.0, n.x * n.x, t.x * t.x), entry(0.0, n.x * n.y, t.x * t.y),
            entry(0.0, n.x * n.z, t.x * t.z), entry(1.0, n.y * n.y, t.y * t.y),
            entry(0.0, n.y * n.z, t.y * t.z), entry(1.0, n.z * n.z, t.z * t.z)};
}

AirDamping::AirDamping(const WindDescription& wind, const ClothModel& cloth) : constants_(wind) {
    const Surface& surface = cloth.surface;
    corners_.reserve(surface.triangles.size());
    for (const std::array<std::uint32_t, 3>& triangle : surface.triangles) {
        const auto slot = [&](std::uint32_t vertex) {
            return static_cast<std::uint32_t>(cloth.slot(surface.particle(vertex)));
        };
        corners_.push_back({slot(triangle[0]), slot(triangle[1]), slot(triangle[2])});
    }
}

void AirDamping::add(Vec3<double> wind, ConstVec3View<double> x, ConstVec3View<double> v,
                     double factor, SymmetricBlocks<double>& blocks) const {
    for (const auto& [a, b, c] : corners_) {
        const Vec3d centre_velocity = (v[a] + v[b] + v[c]) / 3.0;
        const Vec3d normal = cross(x[b] - x[a], x[c] - x[a]);
        const std::array<double, 6> third =
            plate_damping_third(constants_, wind - centre_velocity, normal);
        for (std::size_t e = 0; e < third.size(); ++e) {
            const double entry = factor * third[e];
            blocks.entries[e][a] += entry;
            blocks.entries[e][b] += entry;
            blocks.entries[e][c] += entry;
        }
    }
}

}  // namespace weft
