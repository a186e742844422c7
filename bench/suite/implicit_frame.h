// `weft bench --filter "implicit frame"`: how long solvers take for one frame of implicit Euler.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/suite/frame_solvers.h"
#include "bench/suite/label.h"

namespace weft::bench {

/// What a solver took to come near the solution.
struct FrameFigures {
    double ms = 0.0;
    double ns_per_particle = 0.0;
    std::optional<double> ratio_to_cholesky;  ///< its time over this one's
    double explicit_steps = 0.0;              ///< of velocity Verlet, in as much time
    int iterations = 0, linear_iterations = 0;
};

/// A row of the table; figures are medians over the repeats.
struct FrameRow {
    Label label;
    std::array<std::optional<FrameFigures>, frame_marks.size()> figures;  ///< none: not reached
    std::string note;  ///< why there are no numbers; empty: there are
};

/// One of the solvers that are compared.
struct FrameEntry {
    Label label;
    std::function<std::unique_ptr<FrameSolver>(const FrameProblem&)> make;
    bool shown = true;  ///< false: timed along for the ratios, no row of the table
};

/// Solvers of one size, timed in turn.
struct FrameGroup {
    int size = 0;
    std::vector<FrameEntry> entries;
    int repeats = 3;
};

/// The name of the yardstick's entry.
inline constexpr std::string_view cholesky_frame_name = "implicit frame cholesky";

/// Sizes up to 513, quick up to 97: Newton with each linear solver (cholesky up to 257), and
/// projective dynamics.
std::vector<FrameGroup> frame_groups(bool quick);

/// @param stop asked between timings.
/// @return the group's rows; none where it was stopped.
std::vector<FrameRow> time_frames(const FrameGroup& group, const std::function<bool()>& stop);

}  // namespace weft::bench
