// The three scenes that methods are ranked on, and how long each is flown.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lab/trajectory.h"
#include "weft/scene.h"

namespace weft::lab {

struct WorkScene {
    std::string key;   ///< "soft", "stiff", "windy"
    std::string text;  ///< how it was made from the user's scene
    SceneDescription scene;
};

/// Soft: a tenth of every stiffness and dashpot. Stiff: a hundred times every stiffness, with
/// dashpots that damp the fastest wave to a tenth of what is critical. Windy: the scene in its own
/// wind, or that of the shipped flag. All without gusts.
std::vector<WorkScene> work_scenes(const SceneDescription& scene);

/// From the scene's start over so long a time that much happens and pointwise errors mean
/// something.
struct WorkStretch {
    ParticleState<double> start, end;
    double wanted = 0.0;           ///< before it was shortened [s]
    double limit = 0.0;            ///< scene_limit() [s]
    double motion = 0.0;           ///< motion_between() start and end [m]
    double reference_error = 0.0;  ///< of `end` [m]
    std::string failure{};         ///< why there is none; empty: there is

    [[nodiscard]] double length() const { return end.time - start.time; }
    [[nodiscard]] bool shortened() const { return length() < 0.999 * wanted; }
};

/// How far a disturbance may grow over a stretch.
inline constexpr double most_growth = 1000.0;

/// It is half the scene long, 2 s at most (`quick`: 0.5 s), 3000 limits (400), and so many that the
/// particles make 4 million steps of it (800 000); or as long as a disturbance of all particles by
/// a billionth of a cell grows no more than most_growth times, if that is shorter.
WorkStretch find_work_stretch(Specimen& specimen, bool quick, const Watch& watch);

nlohmann::json work_stretch_to_json(const ClothModel& cloth, const WorkStretch& stretch);
WorkStretch work_stretch_from_json(const ClothModel& cloth, const nlohmann::json& json);

}  // namespace weft::lab
