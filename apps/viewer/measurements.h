// What the plots of the window show: numbers of every lane over the latest simulated time.
#pragma once

#include <vector>

#include "viewer/flight.h"
#include "viewer/time_series.h"

namespace weft::viewer {

/// Of one lane, over simulated time [s].
struct LaneMeasurements {
    TimeSeries kinetic{}, gravity{}, structural{}, shear{}, bend{}, total{};  ///< energies [J]
    TimeSeries strain{};                                                      ///< the largest [%]
    TimeSeries steps_per_second{};  ///< while it computes: steps of a frame over its time [1/s]
    TimeSeries milliseconds{};      ///< of a frame [ms]
    double first_gravity = 0.0;     ///< energy that `gravity` counts from [J]
    double last_time = -1.0;        ///< of the newest sample [s]; negative: none
};

class Measurements {
public:
    /// Takes what is new in a view. A lane whose time went back begins anew, and so do all where
    /// the number of lanes changed.
    void add(const FlightView& view);
    void clear() { lanes_.clear(); }
    [[nodiscard]] const std::vector<LaneMeasurements>& lanes() const { return lanes_; }

private:
    std::vector<LaneMeasurements> lanes_;
};

/// How many steps a second a lane makes while it computes; 0 where that is not known yet.
double steps_per_second(const LaneView& lane);
/// Whether it flies clearly more slowly than is wanted.
bool falls_behind(const FlightView& view);

}  // namespace weft::viewer
