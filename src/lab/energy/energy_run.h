// Flights that keep account of energy and work: the measurements behind the experiment "energy".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lab/laboratory.h"
#include "lab/trajectory.h"

namespace weft::lab {

/// The scene without what takes or gives energy: no air, no drag, no dashpots, pins held still.
SceneDescription conservative_scene(SceneDescription scene);

/// Whether that leaves out anything.
bool is_conservative(const SceneDescription& scene);

/// Energies at one time [J].
struct EnergySample {
    double time = 0.0;  ///< [s]
    double kinetic = 0.0, gravity = 0.0, springs = 0.0;
    double work = 0.0;  ///< of dashpots, drag, air and moving pins since the start

    [[nodiscard]] double total() const { return kinetic + gravity + springs; }
    /// What an exact method keeps as it is.
    [[nodiscard]] double account() const { return total() - work; }
};

struct EnergyRun {
    /// The start, every one of the first 300 steps, then evenly over the flight.
    std::vector<EnergySample> samples;
    std::size_t steps = 0;  ///< made
    std::string failure;    ///< as Flight::failure
};

/// A flight of a method from the scene's start.
struct EnergyPlan {
    std::string_view method;
    double time_step = 0.0;  ///< [s]; of an adaptive method, between two looks
    std::size_t steps = 0;
    std::size_t samples = 0;  ///< of the energies, about so many
    bool exact = false;       ///< implicit systems solved to 1e-8 of the cloth's diagonal, where a
                              ///< user's are to 5e-5: what is left is the method's own error
};

/// @param what begins the trial's name: which scene it is.
Trial energy_trial(const SceneDescription& scene, const EnergyPlan& plan, std::string_view what);

EnergyRun energy_run_from_json(const nlohmann::json& json);

/// A line through E - W against time.
struct EnergyTrend {
    double slope = 0.0;  ///< [W]
    double error = 0.0;  ///< standard error of it, from the scatter of means of stretches [W]
    double from = 0.0, to = 0.0;  ///< the times it was fitted to [s]

    /// More than three standard errors from zero.
    [[nodiscard]] bool is_sure() const;
};

/// Fits to the samples from time `from` on that are within `bound` [J] of the first one.
EnergyTrend energy_trend(const EnergyRun& run, double from, double bound);

}  // namespace weft::lab
