// A method's flight in the experiment "energy", and what it says of the method.
#pragma once

#include <cstddef>
#include <string>

#include "lab/energy/energy_run.h"
#include "weft/integrators.h"

namespace weft::lab {

/// Which flight.
enum class Stage {
    scene,      ///< the scene as it is, for its duration
    quarter,    ///< conservative, at a quarter of the smallest explicit limit
    half,       ///< the same at half of it
    automatic,  ///< conservative, at the step that time_step = "auto" takes
};
std::string name_of(Stage stage);

enum class Verdict { keeps, loses, gains, too_short };
std::string name_of(Verdict verdict);

/// What drifts are measured by.
struct EnergyScale {
    double period = 0.0;  ///< of the fastest mode [s]
    double motion = 0.0;  ///< energy of the motion [J]
};

/// The smallest stable step of the methods that need no damping to have one [s].
double smallest_limit(const StabilityModes& modes);

struct EnergyLeg {
    const IntegratorInfo* info = nullptr;
    Stage stage = Stage::scene;
    double time_step = 0.0;   ///< [s]
    std::size_t planned = 0;  ///< steps
    double wanted = 0.0;      ///< flight that nothing cut short [s]
    bool asked = true;        ///< false: flown for its energy of motion alone
    EnergyRun run;

    [[nodiscard]] bool is_explicit() const {
        return info->kind == IntegratorKind::explicit_steps ||
               info->kind == IntegratorKind::adaptive;
    }
    [[nodiscard]] double flown() const { return static_cast<double>(run.steps) * time_step; }

    /// Of the second half of the flight; where it blew up, as far as E - W had not changed by all
    /// of the motion's energy.
    [[nodiscard]] EnergyTrend trend(const EnergyScale& scale) const;
    /// The trend a period, over the energy of the motion.
    [[nodiscard]] double drift(const EnergyScale& scale) const;
    /// It keeps its energy where the drift is below 1 % in 1000 periods; it gains or loses where it
    /// is more. What blows up gains, and where half of the motion's energy is gone at the end it is
    /// lost. A drift within three standard errors of none cannot be told, nor one in less than ten
    /// periods.
    [[nodiscard]] Verdict verdict(const EnergyScale& scale) const;
    /// The mean of E - W over the last tenth of the samples, less that at the start [J].
    [[nodiscard]] double last_change() const;
    /// The flight failed, or ended with ten times the energy of the motion added.
    [[nodiscard]] bool blew_up(const EnergyScale& scale) const;
    /// The most that E - W differs from the start, either way [J].
    [[nodiscard]] double largest_change() const;
};

}  // namespace weft::lab
