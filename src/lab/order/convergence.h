// Errors of a method at steps of many lengths: what fits of an order are made of.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "lab/order/order_fit.h"
#include "lab/trajectory.h"

namespace weft::lab {

/// A flight in which a method is as exact as it can be: implicit systems solved to 1e-12 m; the
/// methods that iterate with enough iterations to converge (`xpbd` 20, `vbd` 40,
/// `projective-dynamics` 200, or 1e-12 m); adaptive pairs with a tolerance that lets every step
/// be as long as it is asked for.
FlightPlan exact_plan(std::string_view method, double time_step, std::size_t steps);

/// A problem whose end is known.
struct KnownEnd {
    const ParticleState<double>& start;
    const ParticleState<double>& end;
};

/// What it measured, as a trial keeps it.
struct Errors {
    struct Point {
        std::size_t steps = 0;
        double step = 0.0;  ///< [s]
        double x = 0.0;     ///< rms of positions [m]; not finite: it failed
        double v = 0.0;     ///< rms of velocities [m/s]
        std::string failure{};
    };
    std::vector<Point> points;  ///< by falling step

    [[nodiscard]] std::vector<ErrorAtStep> of_positions() const;
    [[nodiscard]] std::vector<ErrorAtStep> of_velocities() const;
    /// The last failure; empty where it never failed.
    [[nodiscard]] std::string failure() const;
};

/// Numbers of steps: `first`, twice that, and so on up to `most`; with halfway ones, `first`, 3/2
/// of it, 2, 3, 4, 6 and so on: for methods of high order, whose errors soon come down to rounding.
struct StepCounts {
    std::size_t first = 0, most = 0;  ///< 0: none
    bool halfway = false;

    [[nodiscard]] std::vector<std::size_t> all() const;
};

/// Flies in so many steps, and no further once positions are within `enough` [m].
Errors measure_errors(Specimen& specimen, std::string_view method, const KnownEnd& problem,
                      const StepCounts& counts, double enough, const Watch& watch);

nlohmann::json errors_to_json(const Errors& errors);
Errors errors_from_json(const nlohmann::json& json);

}  // namespace weft::lab
