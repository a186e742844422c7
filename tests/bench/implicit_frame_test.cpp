// The implicit frame that solvers are timed on, and how timings of it become rows.
#include <gtest/gtest.h>

#include "bench/suite/falling_sheet.h"
#include "bench/suite/implicit_frame.h"

namespace weft::bench {
namespace {

constexpr int small = 17;

const FrameProblem& small_problem() {
    static const FrameProblem problem(small);
    return problem;
}

TEST(FallingSheet, IsTheOneOfTheDocumentation) {
    const Simulation simulation = let_fall(falling_sheet(small, "implicit-euler"));
    EXPECT_NEAR(simulation.total_mass(), 0.2, 1e-12);
    EXPECT_EQ(simulation.pinned_count(), std::size_t{2});
    FrameBuffer buffer;
    simulation.capture(buffer);
    EXPECT_EQ(buffer.positions[0], (Vec3d{0.0, 0.0, 0.0}));
    EXPECT_EQ(buffer.positions[small - 1], (Vec3d{1.0, 0.0, 0.0}));
    const Vec3d corner = buffer.positions.back();
    EXPECT_EQ((Vec3d{corner.x, 0.0, corner.z}), (Vec3d{1.0, 0.0, 1.0}));
    EXPECT_NE(corner.y, 0.0);
    EXPECT_LE(std::abs(corner.y), 0.002);
}

TEST(FrameProblem, MovesAndIsSolvedWell) {
    const FrameProblem& problem = small_problem();
    EXPECT_DOUBLE_EQ(problem.start().time, 0.5);
    const double at_first = problem.error(problem.guess().view());
    EXPECT_GT(at_first, frame_marks[0]);  // there is something to do
    EXPECT_LT(at_first, 0.1);
    EXPECT_LT(problem.residual(), 1e-5);
    // It fell: below where it started by a good part of its size.
    double lowest = 0.0;
    problem.cloth().layout.for_each([&](std::size_t, std::size_t slot) {
        lowest = std::min(lowest, problem.start().x[slot].y);
    });
    EXPECT_LT(lowest, -0.3);
    EXPECT_GT(lowest, -1.5);
}

TEST(FrameSolvers, EachReachesTheSolution) {
    const FrameProblem& problem = small_problem();
    for (const LinearSolver linear : {LinearSolver::multigrid, LinearSolver::aggregation,
                                      LinearSolver::jacobi, LinearSolver::cholesky}) {
        const auto solver = make_newton(problem, linear, 20.0);
        const FrameTiming first = solver->measure(), second = solver->measure();
        ASSERT_TRUE(first.marks[0] && first.marks[1]) << static_cast<int>(linear);
        EXPECT_GT(first.marks[0]->seconds, 0.0);
        EXPECT_GE(first.marks[1]->seconds, first.marks[0]->seconds);
        EXPECT_GE(first.marks[0]->iterations, 1);
        EXPECT_GE(first.marks[1]->iterations, first.marks[0]->iterations);
        EXPECT_GE(first.marks[0]->linear_iterations, first.marks[0]->iterations);
        EXPECT_EQ(second.marks[1]->iterations, first.marks[1]->iterations);  // anew every time
        EXPECT_EQ(second.marks[1]->linear_iterations, first.marks[1]->linear_iterations);
    }
}

TEST(FrameSolvers, ProjectiveDynamicsReachesTheSameSolution) {
    const FrameTiming timing = make_projective(small_problem(), 5.0)->measure();
    ASSERT_TRUE(timing.marks[0] && timing.marks[1]);
    EXPECT_GT(timing.marks[1]->iterations, timing.marks[0]->iterations);
    EXPECT_EQ(timing.marks[0]->linear_iterations, 0);
}

TEST(FrameSolvers, WhatTakesTooLongIsGivenUp) {
    const FrameTiming timing = make_newton(small_problem(), LinearSolver::jacobi, 0.0)->measure();
    EXPECT_FALSE(timing.marks[1].has_value());
}

// Says that it took the next of the given times; less than zero: that it did not come near.
class Scripted final : public FrameSolver {
public:
    explicit Scripted(std::vector<double> seconds) : seconds_(std::move(seconds)) {}
    FrameTiming measure() override {
        FrameTiming timing;
        const double seconds = seconds_[next_++ % seconds_.size()];
        timing.marks[0] = {seconds, 2, 6};
        if (seconds < 1.0) timing.marks[1] = {10.0 * seconds, 20, 60};
        return timing;
    }

private:
    std::vector<double> seconds_;
    std::size_t next_ = 0;
};

FrameEntry scripted(const std::string& name, const std::vector<double>& seconds) {
    FrameEntry entry;
    entry.label = {name, small, small, Precision::f64, 1};
    entry.make = [=](const FrameProblem&) { return std::make_unique<Scripted>(seconds); };
    return entry;
}

TEST(FrameRows, AreMediansAndHaveRatiosToCholesky) {
    FrameGroup group{.size = small, .entries = {}, .repeats = 3};
    group.entries.push_back(scripted("implicit frame multigrid", {0.002, 0.001, 0.010}));
    group.entries.push_back(scripted(std::string(cholesky_frame_name), {0.06, 0.08, 0.07}));
    group.entries.back().shown = false;
    const std::vector<FrameRow> rows = time_frames(group, [] { return false; });
    ASSERT_EQ(rows.size(), std::size_t{1});
    ASSERT_TRUE(rows[0].figures[0] && rows[0].figures[1]);
    const FrameFigures& near = *rows[0].figures[0];
    EXPECT_DOUBLE_EQ(near.ms, 2.0);
    EXPECT_DOUBLE_EQ(*near.ratio_to_cholesky, 35.0);
    EXPECT_DOUBLE_EQ(near.ns_per_particle, 2e6 / (small * small));
    EXPECT_GT(near.explicit_steps, 1.0);  // of a microsecond or so each
    EXPECT_EQ(near.iterations, 2);
    EXPECT_EQ(near.linear_iterations, 6);
    EXPECT_DOUBLE_EQ(rows[0].figures[1]->ms, 20.0);
    EXPECT_DOUBLE_EQ(*rows[0].figures[1]->ratio_to_cholesky, 35.0);
}

TEST(FrameRows, WhatIsNotReachedHasNoNumbers) {
    FrameGroup group{.size = small, .entries = {}, .repeats = 3};
    group.entries.push_back(scripted("implicit frame jacobi", {0.5, 2.0}));
    const std::vector<FrameRow> rows = time_frames(group, [] { return false; });
    ASSERT_EQ(rows.size(), std::size_t{1});
    EXPECT_TRUE(rows[0].figures[0].has_value());
    EXPECT_FALSE(rows[0].figures[0]->ratio_to_cholesky.has_value());
    EXPECT_FALSE(rows[0].figures[1].has_value());
    EXPECT_EQ(rows[0].note, "");
}

TEST(FrameRows, StoppingLeavesNone) {
    FrameGroup group{.size = small, .entries = {}, .repeats = 3};
    group.entries.push_back(scripted("implicit frame jacobi", {0.5}));
    EXPECT_TRUE(time_frames(group, [] { return true; }).empty());
}

}  // namespace
}  // namespace weft::bench
