// A cloth at rest that is nudged a little: whether the nudge grows tells whether a step is stable.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "forces/measure_cloth.h"
#include "lab/laboratory.h"
#include "lab/trajectory.h"

namespace weft::lab {

/// The scene without gravity and wind, its pins held still: nothing moves the cloth but its
/// springs, dashpots and drag.
SceneDescription calm_scene(SceneDescription scene);

/// How the amplitude of a nudge changed in a flight. The amplitude is the root of the energy of
/// springs and motion, so that drifting where no spring resists is not taken for growth.
struct Growth {
    double rate = 0.0;      ///< of its natural logarithm a step, fitted to the flight's second half
    double total = 0.0;     ///< of its natural logarithm, from the start to the end
    std::size_t steps = 0;  ///< made
    std::string failure;    ///< as Flight::failure
};

/// How long to fly, and how closely to look.
struct Search {
    std::size_t steps = 0;    ///< of every flight
    double resolution = 0.0;  ///< of the limit, a part of it: 0.002 is a fifth of a per cent
    double unstable = 1.0;    ///< growth over a flight's second half, ln of it, that counts
};

/// The largest stable step that flights show.
struct ObservedLimit {
    double stable = 0.0;    ///< the longest step at which the nudge did not grow [s]
    double unstable = 0.0;  ///< the shortest at which it did [s]
    int flights = 0;
    bool found = false;  ///< false: no step was unstable, or none stable, far from the prediction

    [[nodiscard]] double middle() const { return 0.5 * (stable + unstable); }
};

class RestingCloth {
public:
    /// @param nudge amplitude of the first displacement, a part of the shortest spring.
    /// @throws Error as build_cloth().
    explicit RestingCloth(const SceneDescription& scene, double nudge = 1e-8);

    [[nodiscard]] Specimen& specimen() { return specimen_; }
    /// What limits a step in theory.
    [[nodiscard]] const StabilityModes& modes() const { return modes_; }
    [[nodiscard]] double omega() const { return modes_.modes.front().omega; }

    /// Flies on from the nudge: the fastest mode, and noise a third as strong, in which every other
    /// mode has its part. Ends early where the nudge has grown ten-thousandfold. Implicit methods
    /// solve their systems to a thousandth of the nudge.
    Growth fly(std::string_view method, double time_step, std::size_t steps, const Watch& watch);

    /// Flights long enough for the limit to be seen to a fifth of a per cent: where theory is
    /// right, the worst mode then grows by e^8 in a flight with a step that much too long.
    /// @param most_evaluations of the forces in a flight; where that is too few, the resolution is
    ///        what they allow.
    [[nodiscard]] Search plan_search(std::string_view method, double predicted,
                                     double most_evaluations) const;

    /// By bisection, from an interval between powers of 1.05 s about the prediction, which has no
    /// other part in it. A step counts as unstable where the nudge grew ten-thousandfold, or as
    /// much over the flight's second half as the search says: e-fold, as a rule.
    ObservedLimit observe(std::string_view method, double predicted, const Search& search,
                          const Watch& watch);

    /// ln of the growth a step that theory expects of the worst mode.
    [[nodiscard]] double predicted_rate(std::string_view method, double time_step) const;

private:
    [[nodiscard]] double amplitude(const ParticleState<double>& state);

    Specimen specimen_;
    ClothMeasures<double> measures_;
    StabilityModes modes_;
    ParticleState<double> nudged_;
    double nudge_;  // [m]
};

}  // namespace weft::lab
