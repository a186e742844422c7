// How fast two flights part that begin almost alike: how long a comparison particle by particle
// means anything.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/laboratory.h"
#include "lab/trajectory.h"

namespace weft::lab {

/// Two flights, and how far apart they are.
struct Parting {
    std::vector<std::array<double, 2>> points;  ///< time [s], rms distance of the particles [m]
    std::string failure;                        ///< why a flight ended early; empty: it did not

    /// When they were first so far apart [s]; none: never.
    [[nodiscard]] std::optional<double> reaches(double distance) const;
};

/// How to part.
struct PartingPlan {
    std::string_view method = "velocity-verlet";
    double time_step = 0.0;    ///< [s]
    std::size_t steps = 0;     ///< at most
    double nudge = 0.0;        ///< that the second flight begins with [m]
    bool one_particle = true;  ///< nudged: one in the middle of the numbering; or all, at random
    double enough = 0.0;       ///< distance at which to stop [m]
};

/// Flies the scene's cloth twice, side by side, in double.
/// @throws Interrupted; Error.
Parting part(const SceneDescription& scene, const PartingPlan& plan, const Watch& watch);

/// Growth of a distance as exp(rate t).
struct PartingRate {
    double rate = 0.0;            ///< [1/s]
    double from = 0.0, to = 0.0;  ///< the range of times it was fitted to [s]
};

/// Least squares of ln distance against time, from where it first passes `low` to where it first
/// passes `high` or the flights end. None where it grew less than tenfold in that range.
std::optional<PartingRate> parting_rate(const Parting& parting, double low, double high);

/// How long an error of `error` [m], spread over all particles, stays below `bound` [m] in this
/// scene, by flying it twice with half of velocity-verlet's limit: from then on a trajectory of
/// such an error says nothing about single particles. At most `longest` [s], which is also returned
/// where it does.
/// @throws Interrupted; Error.
double meaningful_time(const SceneDescription& scene, double error, double bound, double longest,
                       const Watch& watch);

/// Mean rest length of the structural springs [m]; of a cloth without any, its diagonal.
double cell_size(const ClothModel& cloth);

}  // namespace weft::lab
