#include "viewer/measurements.h"

#include <cmath>

namespace weft::viewer {

namespace {

void add_sample(LaneMeasurements& kept, const LaneView& lane) {
    const double time = lane.frame.time;
    const bool at_its_start = kept.total.times().size() < 2;  // where a scene may yet be changed
    if (time == kept.last_time && !at_its_start) return;
    // The zero of the potential is a matter of choice; so far from it, nothing else would be seen.
    if (time <= kept.last_time || kept.last_time < 0.0) {
        kept = {};
        kept.first_gravity = lane.energy.gravity;
    }
    kept.last_time = time;
    kept.kinetic.add(time, lane.energy.kinetic);
    kept.gravity.add(time, lane.energy.gravity - kept.first_gravity);
    kept.structural.add(time, lane.energy.structural);
    kept.shear.add(time, lane.energy.shear);
    kept.bend.add(time, lane.energy.bend);
    kept.total.add(time, lane.energy.total() - kept.first_gravity);
    kept.strain.add(time, 100.0 * lane.largest_strain.strain);
    if (lane.milliseconds <= 0.0) return;
    kept.steps_per_second.add(time, steps_per_second(lane));
    kept.milliseconds.add(time, lane.milliseconds);
}

}  // namespace

void Measurements::add(const FlightView& view) {
    if (lanes_.size() != view.lanes.size()) lanes_.assign(view.lanes.size(), {});
    for (std::size_t k = 0; k < lanes_.size(); ++k) add_sample(lanes_[k], view.lanes[k]);
}

double steps_per_second(const LaneView& lane) {
    if (lane.milliseconds <= 0.0) return 0.0;
    return static_cast<double>(lane.steps_per_frame) / (1e-3 * lane.milliseconds);
}

bool falls_behind(const FlightView& view) {
    return view.playing && view.reached_speed > 0.0 && view.reached_speed < 0.9 * view.speed;
}

}  // namespace weft::viewer
