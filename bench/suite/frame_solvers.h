// What solves the frame problem, timed until it is near the solution.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "bench/suite/frame_problem.h"

namespace weft::bench {

/// Distances from the solution that solvers are timed to [m]: FrameProblem::error() below each.
inline constexpr std::array<double, 2> frame_marks{1e-3, 1e-4};

/// By mark.
struct FrameTiming {
    struct Mark {
        double seconds = 0.0;
        int iterations = 0;         ///< of the method
        int linear_iterations = 0;  ///< of Newton's linear solver, within them
    };
    std::array<std::optional<Mark>, frame_marks.size()> marks;  ///< none: not reached
};

/// Solves from FrameProblem::guess(), anew every time.
class FrameSolver {
public:
    virtual ~FrameSolver() = default;

    /// What does not depend on positions (orderings, factors of constant matrices, memory) was done
    /// when the solver was made, and takes no part in the time; nor does looking at the error.
    virtual FrameTiming measure() = 0;
};

/// Newton's method with one of weft's linear solvers.
/// @param most_seconds gives up where a mark takes longer.
/// @param problem outlives the solver.
std::unique_ptr<FrameSolver> make_newton(const FrameProblem& problem, LinearSolver linear_solver,
                                         double most_seconds);

/// weft's projective dynamics, each time with as many iterations as a mark takes: found by trying.
std::unique_ptr<FrameSolver> make_projective(const FrameProblem& problem, double most_seconds);

}  // namespace weft::bench
