#include "bench/suite/implicit_frame.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/suite/contestant.h"
#include "bench/suite/falling_sheet.h"
#include "bench/suite/median.h"
#include "weft/error.h"

namespace weft::bench {

namespace {

// A solver that has taken so long is not timed again [s].
constexpr double long_enough = 8.0;

struct NamedSolver {
    std::string_view name;
    LinearSolver linear_solver;
};
constexpr std::array newton_solvers{NamedSolver{"multigrid", LinearSolver::multigrid},
                                    NamedSolver{"aggregation", LinearSolver::aggregation},
                                    NamedSolver{"jacobi", LinearSolver::jacobi},
                                    NamedSolver{"cholesky", LinearSolver::cholesky}};
constexpr int largest_for_cholesky = 257;

// An entry while its group is timed.
struct Runner {
    const FrameEntry& entry;
    std::unique_ptr<FrameSolver> solver{};
    std::vector<FrameTiming> timings{};
    double seconds = 0.0;
    std::string failure{};

    void make(const FrameProblem& problem) try {
        solver = entry.make(problem);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::diverged) throw;
        failure = error.what();
    }

    void measure() {
        if (!solver || seconds > long_enough) return;
        timings.push_back(solver->measure());
        for (const auto& mark : timings.back().marks) seconds += mark ? mark->seconds : 0.0;
        if (!timings.back().marks.back()) seconds += long_enough;  // it ran into its limit
    }

    // Nothing where the mark was not reached every time.
    [[nodiscard]] std::optional<double> median_seconds(std::size_t mark) const {
        std::vector<double> all;
        for (const FrameTiming& timing : timings) {
            if (!timing.marks[mark]) return std::nullopt;
            all.push_back(timing.marks[mark]->seconds);
        }
        return all.empty() ? std::nullopt : std::optional(median(std::move(all)));
    }
};

FrameRow row_of(const Runner& runner, const Runner* cholesky, double explicit_step) {
    FrameRow row{runner.entry.label, {}, runner.failure};
    const double particles = static_cast<double>(row.label.columns) * row.label.rows;
    for (std::size_t n = 0; n < frame_marks.size(); ++n) {
        const std::optional<double> seconds = runner.median_seconds(n);
        if (!seconds) continue;
        const FrameTiming::Mark& last = *runner.timings.back().marks[n];
        row.figures[n] = {.ms = 1e3 * *seconds,
                          .ns_per_particle = 1e9 * *seconds / particles,
                          .ratio_to_cholesky = {},
                          .explicit_steps = *seconds / explicit_step,
                          .iterations = last.iterations,
                          .linear_iterations = last.linear_iterations};
        if (cholesky == nullptr) continue;
        if (const auto yardstick = cholesky->median_seconds(n)) {
            row.figures[n]->ratio_to_cholesky = *yardstick / *seconds;
        }
    }
    return row;
}

std::unique_ptr<Contestant> explicit_steps(int size) {
    SceneDescription scene = falling_sheet(size, "velocity-verlet");
    scene.integrator.precision = Precision::f32;
    return make_stepping(scene, 1);
}

std::vector<FrameRow> failed_rows(const FrameGroup& group, const Error& error) {
    std::vector<FrameRow> rows;
    for (const FrameEntry& entry : group.entries) {
        if (entry.shown) rows.push_back({entry.label, {}, error.what()});
    }
    return rows;
}

std::vector<FrameRow> time_solvers(const FrameGroup& group, const FrameProblem& problem,
                                   const std::function<bool()>& stop) {
    const std::unique_ptr<Contestant> stepping = explicit_steps(group.size);
    std::vector<Runner> runners;
    for (const FrameEntry& entry : group.entries) {
        if (stop()) return {};
        runners.push_back({entry});
        runners.back().make(problem);
    }
    std::vector<double> step_seconds;
    for (int n = 0; n < group.repeats; ++n) {
        for (Runner& runner : runners) {
            if (stop()) return {};
            runner.measure();
        }
        const Measurement steps = stepping->measure(0.03);
        step_seconds.push_back(steps.seconds / steps.steps);
    }
    const auto cholesky = std::ranges::find_if(
        runners, [](const Runner& r) { return r.entry.label.name == cholesky_frame_name; });
    std::vector<FrameRow> rows;
    for (const Runner& runner : runners) {
        if (!runner.entry.shown) continue;
        rows.push_back(
            row_of(runner, cholesky == runners.end() ? nullptr : &*cholesky, median(step_seconds)));
    }
    return rows;
}

FrameGroup frame_group(int size, bool quick) {
    FrameGroup group{.size = size, .entries = {}, .repeats = quick ? 1 : 3};
    const auto add = [&](std::string_view name, auto make) {
        FrameEntry entry;
        entry.label = {fmt::format("implicit frame {}", name), size, size, Precision::f64, 1};
        entry.make = make;
        group.entries.push_back(std::move(entry));
    };
    const double most_seconds = quick ? 2.0 : 30.0;
    for (const NamedSolver& solver : newton_solvers) {
        if (solver.linear_solver == LinearSolver::cholesky && size > largest_for_cholesky) continue;
        add(solver.name, [=](const FrameProblem& problem) {
            return make_newton(problem, solver.linear_solver, most_seconds);
        });
    }
    const double most_projective = quick ? 0.5 : 4.0;
    add("projective-dynamics",
        [=](const FrameProblem& problem) { return make_projective(problem, most_projective); });
    return group;
}

}  // namespace

std::vector<FrameGroup> frame_groups(bool quick) {
    std::vector<FrameGroup> groups;
    for (const int size : {41, 97, 257, 513}) {
        if (quick && size > 97) continue;
        groups.push_back(frame_group(size, quick));
    }
    return groups;
}

std::vector<FrameRow> time_frames(const FrameGroup& group, const std::function<bool()>& stop) {
    try {
        const FrameProblem problem(group.size, stop);
        if (stop()) return {};
        return time_solvers(group, problem, stop);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::diverged) throw;
        return failed_rows(group, error);
    }
}

}  // namespace weft::bench
