// One run watched for the two readings of "stable time": when the cloth comes to rest, and when it
// blows up.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lab/laboratory.h"
#include "lab/trajectory.h"

namespace weft::lab {

/// Rest: kinetic energy below this part of the energy released.
inline constexpr double rest_fraction = 1e-3;
/// Rest counts where it lasts to the run's end and at least for this part of the run.
inline constexpr double rest_share = 0.05;

/// What to run.
struct RestPlan {
    std::string method;       ///< of the catalogue, or the name of a seed_updates() row
    double drag_rate = 0.0;   ///< of make_seed_update() [1/s]
    double time_step = 0.0;   ///< [s]
    double duration = 0.0;    ///< [s]
    double look_every = 0.5;  ///< [s] between two samples
    /// Energy that the way to rest sets free [J]; none: the largest kinetic energy of the run
    /// stands in its place, and gaining energy is not looked for.
    std::optional<double> released;
};

/// The cloth at one moment of a run.
struct RestSample {
    double time = 0.0;      ///< [s]
    double kinetic = 0.0;   ///< [J]
    double gained = 0.0;    ///< energy over that of the start [J]
    double wrinkles = 0.0;  ///< Wrinkles::angle() [degrees]
    double strain = 0.0;    ///< the largest
};

/// How it went. Times are those of steps; none: it did not happen within the run.
struct RestRun {
    std::optional<double> rest;     ///< from when on it stays at rest [s]
    std::optional<double> gain;     ///< when its energy first is that of the start + released [s]
    std::optional<double> blow_up;  ///< not finite, or a strain beyond Divergence::max_strain [s]
    std::string failure;            ///< a step could not be made, and why
    std::vector<RestSample> samples;

    /// When the picture is wrong for good: blow-up, gain or failure, whichever came first [s].
    [[nodiscard]] std::optional<double> wrecked() const;
    /// The sample nearest to a time; not finite values where the run was over by then.
    [[nodiscard]] RestSample at(double time) const;
};

RestRun run_to_rest(Specimen& specimen, const RestPlan& plan, const Watch& watch);

nlohmann::json to_json(const RestRun& run);
RestRun rest_run_from_json(const nlohmann::json& json);

}  // namespace weft::lab
