#include "lab/stability/stability_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "weft/integrators.h"

namespace weft::lab {

namespace {

// How far from 0 a mode damped by zeta stays stable. A growth below 1e-9 counts as none: rounding
// of the amplification.
double first_crossing(std::string_view method, double zeta, double most) {
    constexpr double step = 0.01;
    constexpr int halvings = 40;
    const auto stable = [&](double size) {
        return amplification(method, size, zeta) <= 1.0 + 1e-9;
    };
    double inside = 0.0, outside = 1e-4;
    while (stable(outside)) {
        if (outside >= most) return most;
        inside = outside;
        outside = std::min(outside + step, most);
    }
    for (int n = 0; n < halvings; ++n) {
        const double middle = 0.5 * (inside + outside);
        (stable(middle) ? inside : outside) = middle;
    }
    return inside;
}

std::vector<PlanePoint> growth(std::string_view method, double zeta, double first, double last,
                               int points) {
    std::vector<PlanePoint> curve;
    for (int n = 0; n < points; ++n) {
        const double size = first * std::pow(last / first, static_cast<double>(n) / (points - 1));
        curve.push_back({size, amplification(method, size, zeta)});
    }
    return curve;
}

}  // namespace

std::vector<PlanePoint> stability_boundary(std::string_view method, int rays, double most) {
    std::vector<PlanePoint> boundary;
    for (int n = 0; n <= rays; ++n) {
        const double angle = 0.5 * std::numbers::pi * n / rays;  // from the imaginary axis
        const double zeta = n == 0 ? 0.0 : n == rays ? 1.0 : std::sin(angle);
        const double size = first_crossing(method, zeta, most);
        boundary.push_back({0.0 - zeta * size, size * std::sqrt(std::max(1.0 - zeta * zeta, 0.0))});
    }
    for (std::size_t n = boundary.size() - 1; n-- > 0;) {
        boundary.push_back({boundary[n][0], 0.0 - boundary[n][1]});
    }
    return boundary;
}

std::array<PlanePoint, 2> eigenvalues(const Mode& mode, double time_step) {
    const double decay = 0.5 * mode.damping_rate;
    const double squared = mode.omega * mode.omega - decay * decay;
    const double root = std::sqrt(std::abs(squared)) * time_step;
    const double real = 0.0 - decay * time_step;
    if (squared >= 0.0) return {{{real, root}, {real, -root}}};
    return {{{real + root, 0.0}, {real - root, 0.0}}};
}

std::vector<PlanePoint> growth_on_imaginary_axis(std::string_view method, double first, double last,
                                                 int points) {
    return growth(method, 0.0, first, last, points);
}

std::vector<PlanePoint> growth_on_real_axis(std::string_view method, double first, double last,
                                            int points) {
    return growth(method, 1.0, first, last, points);
}

}  // namespace weft::lab
