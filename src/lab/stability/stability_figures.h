// The figures of the experiment "stability".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lab/section.h"
#include "lab/stability/stability_region.h"

namespace weft::lab {

/// Growth measured on both sides of a method's limit.
struct GrowthCurve {
    std::string_view method;
    double predicted = 0.0;            ///< limit [s]
    std::vector<PlanePoint> measured;  ///< (dt / predicted limit, ln of the growth a step)
};

struct StabilityFigures {
    std::vector<std::string_view> methods;
    std::optional<double> scene_step;  ///< that the scene is flown with, by an explicit method [s]
    std::vector<Mode> spectrum;        ///< by rising omega
    std::vector<Mode> limiting;        ///< what predictions are made of; the fastest first
    double limit_of_verlet = 0.0;      ///< [s]
    std::vector<GrowthCurve> growth;
};

/// Growth a step against dt / limit, measured and predicted; none where no method has a limit.
std::optional<Plot> growth_plot(const StabilityFigures& figures);

/// Stability regions of explicit methods, and the scene's eigenvalues times its step on them.
std::optional<Plot> region_plot(const StabilityFigures& figures);

/// What implicit methods do to undamped and to critically damped modes of any frequency.
std::vector<Plot> implicit_plots(const StabilityFigures& figures);

}  // namespace weft::lab
