// `weft bench --filter motion`: how far methods go astray in half a second of the falling sheet, at
// what cost.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/suite/label.h"
#include "weft/vec3.h"

namespace weft::bench {

/// A method with its steps.
struct MotionEntry {
    std::string_view method;
    std::optional<int> steps_per_frame;  ///< none: 0.9 of the stable step, or
    std::optional<double> tolerance;     ///< of a method that chooses its steps [m]
    Label label;                         ///< "motion xpbd 10", "motion dopri5 1e-3"
};

/// How a method moved the sheet; the time is the median over the repeats.
struct MotionFigures {
    double steps_per_frame = 0.0;  ///< frames of 1/60 s
    double rms_error = 0.0;        ///< of positions at the end, from the reference's [m]
    double energy_change = 0.0;    ///< of the sum of kinetic energy, springs' and height [J]
    double ms_per_frame = 0.0;
};

struct MotionRow {
    Label label;
    std::optional<MotionFigures> figures;
    std::string note;  ///< why there are none; empty: there are
};

/// Where the sheet is at the end: velocity Verlet at a sixteenth of its largest stable step.
struct MotionReference {
    std::vector<Vec3d> positions;  ///< [m]
    double kinetic_energy = 0.0;   ///< [J]
};

/// All methods that are compared, 33 x 33 particles in double.
std::vector<MotionEntry> motion_entries();

/// @throws Error (diverged).
MotionReference motion_reference();

/// @param stop asked between runs; nothing where it was stopped.
std::optional<MotionRow> time_motion(const MotionEntry& entry, const MotionReference& reference,
                                     int repeats, const std::function<bool()>& stop);

}  // namespace weft::bench
