// Flying a scene's cloth in double by any method and step from any state: what experiments measure.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cloth/cloth_model.h"
#include "cloth/particle_state.h"
#include "integrators/integrator.h"
#include "lab/laboratory.h"
#include "simulation/cloth_system.h"
#include "simulation/stability.h"
#include "weft/measures.h"

namespace weft::lab {

/// A scene's cloth with its forces, in double and on one thread. Trials that run beside each other
/// each make their own.
class Specimen {
public:
    explicit Specimen(SceneDescription scene);
    Specimen(const Specimen&) = delete;
    Specimen& operator=(const Specimen&) = delete;

    [[nodiscard]] const SceneDescription& scene() const { return scene_; }
    [[nodiscard]] const ClothModel& cloth() const { return cloth_; }
    [[nodiscard]] ClothSystem<double>& system() { return system_; }
    [[nodiscard]] std::size_t particle_count() const { return cloth_.particle_count; }

    /// The scene's initial state: rest positions, pins where they are at time 0.
    [[nodiscard]] ParticleState<double> start() const;
    /// Of springs, gravity and motion.
    [[nodiscard]] Energy energy(const ParticleState<double>& state) const;
    /// The springs linearised at the start: what limits a step.
    [[nodiscard]] const StabilityModes& modes();

private:
    SceneDescription scene_;
    ClothModel cloth_;
    mutable ClothSystem<double> system_;
    std::optional<StabilityModes> modes_;
};

/// How to fly.
struct FlightPlan {
    std::string_view method;
    double time_step = 0.0;  ///< [s]; for an adaptive method the interval between two looks
    std::size_t steps = 0;
    std::optional<double> tolerance;  ///< IntegratorDescription::tolerance; implicit methods: how
                                      ///< exactly their systems are solved [m]; none: 1e-12 m
    std::optional<int> iterations;    ///< IntegratorDescription::iterations
};

/// How it went.
struct Flight {
    ParticleState<double> state;  ///< at the end, or when it failed
    std::size_t steps = 0;        ///< made
    std::string failure;          ///< why it ended early, one line; empty: it did not
    SolverCounts counts;          ///< of methods that count
    double seconds = 0.0;         ///< of wall time, stepping alone
    [[nodiscard]] bool ok() const { return failure.empty(); }
};

/// Looks at the state after a step; false ends the flight there.
using Look = std::function<bool(std::size_t step, const ParticleState<double>& state)>;

/// Flies from `start`. A flight fails where a step cannot be made, a co-ordinate is not finite, or
/// a spring is longer than Divergence::max_strain allows (looked at every 16 steps and at the end).
Flight fly(Specimen& specimen, const FlightPlan& plan, const ParticleState<double>& start,
           const Watch& watch, const Look& look = {});

/// Root mean square over the particles of |a - b|, of arrays [slot].
double rms_difference(const ClothModel& cloth, ConstVec3View<double> a, ConstVec3View<double> b);
/// Of two states' positions [m].
double rms_distance(const ClothModel& cloth, const ParticleState<double>& a,
                    const ParticleState<double>& b);

/// Of a state, [particle][x, y, z, vx, vy, vz]: to keep in a trial's result without loss, and back.
nlohmann::json state_to_json(const ClothModel& cloth, const ParticleState<double>& state);
ParticleState<double> state_from_json(const ClothModel& cloth, const nlohmann::json& json);

}  // namespace weft::lab
