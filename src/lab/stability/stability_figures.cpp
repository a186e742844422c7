#include "lab/stability/stability_figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "weft/integrators.h"

namespace weft::lab {

namespace {

// ln of the growth a step of the worst of the modes.
double predicted_growth(const StabilityFigures& figures, std::string_view method, double step) {
    double largest = 0.0;
    for (const std::vector<Mode>* modes : {&figures.spectrum, &figures.limiting}) {
        for (const Mode& mode : *modes) {
            if (!(mode.omega > 0.0)) continue;
            const double zeta = mode.damping_rate / (2.0 * mode.omega);
            largest = std::max(largest, amplification(method, mode.omega * step, zeta));
        }
    }
    return largest > 0.0 ? std::log(largest) : 0.0;
}

// Boundaries of one shape are drawn once, under all their names.
struct Region {
    std::vector<std::string_view> methods;
    std::vector<PlanePoint> boundary;
};

bool same(const std::vector<PlanePoint>& a, const std::vector<PlanePoint>& b) {
    return std::ranges::equal(a, b, [](const PlanePoint& p, const PlanePoint& q) {
        return std::hypot(p[0] - q[0], p[1] - q[1]) < 1e-5;
    });
}

template <typename Kinds, typename Shape>
std::vector<Region> shapes_of(const StabilityFigures& figures, const Kinds& wanted,
                              const Shape& shape) {
    std::vector<Region> regions;
    for (const std::string_view method : figures.methods) {
        if (!wanted(find_integrator(method)->kind)) continue;
        std::vector<PlanePoint> boundary = shape(method);
        const auto found = std::ranges::find_if(
            regions, [&](const Region& region) { return same(region.boundary, boundary); });
        if (found != regions.end()) {
            found->methods.push_back(method);
        } else {
            regions.push_back({{method}, std::move(boundary)});
        }
    }
    return regions;
}

Series series_of(const Region& region) {
    return {fmt::format("{}", fmt::join(region.methods, ", ")), region.boundary,
            Series::Style::line, std::string(region.methods.front())};
}

Series eigenvalue_marks(std::span<const Mode> modes, double step, std::string name,
                        std::string look) {
    Series marks{std::move(name), {}, Series::Style::marks, std::move(look)};
    for (const Mode& mode : modes) {
        for (const PlanePoint& z : eigenvalues(mode, step)) marks.points.push_back(z);
    }
    return marks;
}

bool is_implicit(IntegratorKind kind) {
    return kind == IntegratorKind::implicit || kind == IntegratorKind::by_springs;
}

}  // namespace

std::optional<Plot> growth_plot(const StabilityFigures& figures) {
    if (figures.growth.empty()) return std::nullopt;
    Plot plot{"growth",
              "Growth on both sides of the limit",
              "dt / predicted limit",
              "growth of the nudge a step (natural logarithm)",
              false,
              false,
              false,
              {},
              {},
              {}};
    double largest_gap = 0.0;
    for (const GrowthCurve& curve : figures.growth) {
        Series line{{}, {}, Series::Style::line, std::string(curve.method)};
        constexpr int points = 121;
        for (int n = 0; n < points; ++n) {
            const double part = 0.8 + 0.4 * n / (points - 1);
            line.points.push_back(
                {part, predicted_growth(figures, curve.method, part * curve.predicted)});
        }
        plot.series.push_back(std::move(line));
        plot.series.push_back({std::string(curve.method), curve.measured, Series::Style::marks,
                               std::string(curve.method)});
        for (const PlanePoint& point : curve.measured) {
            if (point[0] <= 1.0) continue;
            const double expected =
                predicted_growth(figures, curve.method, point[0] * curve.predicted);
            largest_gap = std::max(largest_gap, std::abs(point[1] / expected - 1.0));
        }
    }
    plot.text = fmt::format(
        "Marks are measured, lines predicted from the scene's modes. Up to the limit nothing "
        "grows; "
        "beyond it every one of {} methods does, as predicted to within {:.2g} %. Symplectic "
        "methods leave the limit steeply, Runge-Kutta methods slowly.",
        figures.growth.size(), 100.0 * largest_gap);
    return plot;
}

std::optional<Plot> region_plot(const StabilityFigures& figures) {
    constexpr int rays = 180;
    const std::vector<Region> regions = shapes_of(
        figures, [](IntegratorKind kind) { return !is_implicit(kind); },
        [](std::string_view method) { return stability_boundary(method, rays); });
    if (regions.empty()) return std::nullopt;
    Plot plot{"regions",
              "Stability regions and the eigenvalues of the scene",
              "real part of λ dt",
              "imaginary part of λ dt",
              false,
              false,
              true,
              {},
              {},
              {}};
    for (const Region& region : regions) plot.series.push_back(series_of(region));
    const double auto_step = 0.9 * figures.limit_of_verlet;
    const double fastest = figures.spectrum.empty() ? 0.0 : figures.spectrum.back().omega;
    plot.series.push_back(eigenvalue_marks(
        figures.spectrum, auto_step,
        fmt::format("eigenvalues at {:.3g} s, 0.9 × velocity-verlet's limit", auto_step),
        "neutral"));
    constexpr double drawn = 4.0;  // beyond, the regions would be too small to see
    std::string own = "The scene's own step is not drawn.";
    if (figures.scene_step && *figures.scene_step * fastest < drawn) {
        plot.series.push_back(
            eigenvalue_marks(figures.spectrum, *figures.scene_step,
                             fmt::format("at the scene's own {:.3g} s", *figures.scene_step), ""));
        own = fmt::format("At the scene's own step of {:.3g} s they reach {:.3g} from 0.",
                          *figures.scene_step, *figures.scene_step * fastest);
    }
    plot.text = fmt::format(
        "Each curve encloses the values of λ dt at which its method does not grow; a step is "
        "stable "
        "where all eigenvalues λ of the scene, times the step, lie inside. The marks are {} Ritz "
        "values, which stand for all; at {:.3g} s they reach {:.3g} from 0. {}",
        figures.spectrum.size(), auto_step, auto_step * fastest, own);
    return plot;
}

std::vector<Plot> implicit_plots(const StabilityFigures& figures) {
    constexpr double first = 0.01, last = 1000.0;
    constexpr int points = 101;
    const auto wanted = [](IntegratorKind kind) { return is_implicit(kind); };
    std::vector<Plot> plots;
    const auto add = [&](const char* id, const char* title, const char* x_label, const auto& curve,
                         const std::string& text) {
        const std::vector<Region> shapes = shapes_of(figures, wanted, [&](std::string_view method) {
            return curve(method, first, last, points);
        });
        if (shapes.empty()) return;
        Plot plot{id, title, x_label, "size of the mode after a step", true, false, false,
                  {}, {},    text};
        for (const Region& shape : shapes) plot.series.push_back(series_of(shape));
        plots.push_back(std::move(plot));
    };
    add("implicit-undamped", "What implicit methods leave of an undamped mode in a step", "ω dt",
        growth_on_imaginary_axis,
        "A mode without damping should keep its size, 1. implicit-midpoint and trapezoidal keep it "
        "at every step; the others damp fast modes away, implicit-euler already those that it "
        "resolves. projective-dynamics, xpbd and vbd solve implicit Euler's equations.");
    add("implicit-damped", "What implicit methods leave of a critically damped mode in a step",
        "ω dt", growth_on_real_axis,
        "A critically damped mode should die out. implicit-midpoint and trapezoidal keep fast ones "
        "ringing: their curves climb back to 1.");
    return plots;
}

}  // namespace weft::lab
