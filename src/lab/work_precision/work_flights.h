// Flights of one method over a scene at steps of many lengths: what they cost and how far off they
// end.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "lab/work_precision/work_scenes.h"

namespace weft::lab {

/// A flight of a method.
struct WorkPoint {
    double step = 0.0;       ///< [s]; of an adaptive method the mean of those it took
    double tolerance = 0.0;  ///< of an adaptive method [m]; 0: of another
    std::size_t steps = 0, evaluations = 0, newton_iterations = 0, linear_iterations = 0;
    double error = 0.0;  ///< rms distance from the reference at the end [m]; not finite: it failed
    double ms = 0.0;     ///< wall time, the shortest of some repetitions; varies
    std::string failure{};

    [[nodiscard]] bool ok() const { return failure.empty(); }
};

struct WorkSeries {
    std::vector<WorkPoint> points;  ///< by falling step or tolerance
    bool bounded = false;           ///< it ended because another flight would take too much work
};

/// What a study does with a method.
struct WorkPlan {
    std::string_view method;
    bool quick = false;
};

/// Explicit methods begin at 0.95 of their own limit (of `velocity-verlet`'s, where theirs is less
/// than a quarter of that), methods without a limit at 1/15 s, all with four steps at least; then
/// each time half the step. Adaptive ones begin with a tolerance of a hundredth of the motion, then
/// each time a tenth of it. Everything else is as the methods are by default, but Newton's method
/// ends after 300 iterations (`quick`: 100) and is exact to a millionth of the cloth's size at
/// first, to an eighth of that with each halving. It goes on until an error is below 5e-5 of the
/// motion, or another flight would cost too much: counted in evaluations and iterations, not in
/// time, so that it is the same on every machine.
WorkSeries measure_work(Specimen& specimen, const WorkPlan& plan, const WorkStretch& stretch,
                        const Watch& watch);

nlohmann::json work_series_to_json(const WorkSeries& series);
WorkSeries work_series_from_json(const nlohmann::json& json);

}  // namespace weft::lab
