// A short stretch of the scene's own motion in which its forces are as smooth as they get: what
// orders are measured on.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lab/trajectory.h"

namespace weft::lab {

struct SceneStretch {
    ParticleState<double> start, end;  ///< a state in motion, and the reference's later
    double limit = 0.0;            ///< the step by which the length was chosen: scene_limit() [s]
    double reference_error = 0.0;  ///< of `end` [m]
    std::size_t triangles = 0;
    std::size_t edge_on = 0;  ///< of them, that the air met edge-on at some time of the stretch
    double motion = 0.0;      ///< motion_between() start and end [m]
    std::string failure{};    ///< why there is none; empty: there is

    [[nodiscard]] double length() const { return end.time - start.time; }
};

/// The shorter of the stable steps of `velocity-verlet` and `yoshida4`; 10 ms where none is [s].
double scene_limit(Specimen& specimen);

/// The rms distance of the states' positions [m]; 0 where it is no more than rounding.
double motion_between(const ClothModel& cloth, const ParticleState<double>& start,
                      const ParticleState<double>& end);

/// The stretch begins in the middle of the scene, or at 1 s if that is sooner (`quick`: 0.25 s), or
/// after 4000 steps of half the limit, for large cloths fewer; if a kink (kinks.h) is within, after
/// it. It is 8 limits long, and ends before the next kink. `rk4` flies to its start, the reference
/// to its end.
SceneStretch find_scene_stretch(Specimen& specimen, bool quick, const Watch& watch);

nlohmann::json stretch_to_json(const ClothModel& cloth, const SceneStretch& stretch);
SceneStretch stretch_from_json(const ClothModel& cloth, const nlohmann::json& json);

/// "0.36 s from 1.00 s on", for texts.
std::string stretch_text(const SceneStretch& stretch);

}  // namespace weft::lab
