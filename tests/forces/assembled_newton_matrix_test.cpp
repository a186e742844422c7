// Solvers of Newton's matrix as assembled from springs, on grids and meshes: against the readable
// products of forces/linearised.h and dense factorisations.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <memory>
#include <string>
#include <vector>

#include "forces/assembled_newton_matrix.h"
#include "math/parallel.h"
#include "support/newton_problems.h"

namespace weft::test {
namespace {

constexpr const char* all_solvers[] = {"cholesky", "simplicial cholesky", "jacobi", "aggregation"};

Eigen::MatrixXd dense_matrix(const NewtonProblem& problem) {
    const auto size = static_cast<Eigen::Index>(3 * problem.r.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(size, size);
    const std::vector<char> free = free_slots(problem.cloth);
    Vec3Array<double> unit(problem.r.size());
    for (std::size_t s = 0; s < problem.r.size(); ++s) {
        if (free[s] == 0) continue;
        for (int c = 0; c < 3; ++c) {
            unit.set(s, {c == 0 ? 1.0 : 0.0, c == 1 ? 1.0 : 0.0, c == 2 ? 1.0 : 0.0});
            const Vec3Array<double> column = product(problem, unit);
            for (std::size_t q = 0; q < problem.r.size(); ++q) {
                const Vec3d v = column[q];
                a.block<3, 1>(static_cast<Eigen::Index>(3 * q),
                              static_cast<Eigen::Index>(3 * s) + c)
                    << v.x,
                    v.y, v.z;
            }
        }
        unit.set(s, {});
    }
    return a;
}

TEST(AssembledSolver, AgreesWithADenseFactorisation) {
    for (const NewtonSheet& sheet : small_sheets()) {
        NewtonProblem problem(sheet.cloth);
        const Vec3Array<double> r = masked(problem, problem.r);
        Eigen::VectorXd right(static_cast<Eigen::Index>(3 * r.size()));
        for (std::size_t s = 0; s < r.size(); ++s) {
            right.segment<3>(static_cast<Eigen::Index>(3 * s)) << r[s].x, r[s].y, r[s].z;
        }
        const Eigen::VectorXd solution = dense_matrix(problem).ldlt().solve(right);
        for (const std::string name : all_solvers) {
            SCOPED_TRACE(sheet.name + " " + name);
            const auto solver =
                make_assembled_solver(sheet.cloth, name, chosen_instruction_set(), 1);
            ASSERT_NE(solver, nullptr);
            const bool direct = name.ends_with("cholesky");
            EXPECT_EQ(solver->name(), direct ? "cholesky" : name);
            solver->linearise(problem.x(), inverse_tau, problem.blocks);
            const double tolerance = direct ? 1e-11 : 1e-8;
            const LinearReport report =
                solver->solve(problem.right(), tolerance, 2000, problem.d.view());
            EXPECT_TRUE(report.converged);
            EXPECT_LE(report.residual, tolerance);
            EXPECT_NEAR(residual_of(problem), report.residual, 0.01 * tolerance);
            double error = 0.0;
            for (std::size_t s = 0; s < r.size(); ++s) {
                const auto n = static_cast<Eigen::Index>(3 * s);
                const Vec3d d = problem.d[s];
                error += (solution.segment<3>(n) - Eigen::Vector3d(d.x, d.y, d.z)).squaredNorm();
            }
            EXPECT_LT(std::sqrt(error), 1e3 * tolerance * solution.norm());
        }
    }
}

TEST(AssembledSolver, OfAnotherNameIsNone) {
    const NewtonSheet sheet = grid_sheet(3, 3, false);
    EXPECT_EQ(make_assembled_solver(sheet.cloth, "multigrid", InstructionSet::scalar, 1), nullptr);
    EXPECT_EQ(make_assembled_solver(sheet.cloth, "", InstructionSet::scalar, 1), nullptr);
}

TEST(AssembledSolver, ToleratesWhateverIsAsked) {
    const NewtonSheet sheet = mesh_sheet(sheet_mesh(40, 40, 1.0 / 39, true), "triangles", true);
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        for (const std::string name : {"jacobi", "aggregation"}) {
            NewtonProblem problem(sheet.cloth);
            const auto solver =
                make_assembled_solver(sheet.cloth, name, static_cast<InstructionSet>(set), 1);
            solver->linearise(problem.x(), inverse_tau, problem.blocks);
            for (const double tolerance : {1.0, 0.1, 0.03, 1e-3, 1e-6, 1e-9}) {
                const LinearReport report =
                    solver->solve(problem.right(), tolerance, 5000, problem.d.view());
                EXPECT_TRUE(report.converged) << name << " " << tolerance;
                EXPECT_LE(residual_of(problem), 1.1 * tolerance) << name << " " << tolerance;
            }
        }
    }
}

// Stiff and light: the mass is below the last place in float of what springs add to it.
TEST(AssembledSolver, SolvesWhereFloatsDigitsEnd) {
    SceneDescription scene = bare_sheet(60, 60);
    scene.material.structural = {1e6, 0.0};
    scene.material.shear = {5e5, 0.0};
    scene.material.bend = {1e5, 0.0};
    scene.pins = {{EdgeSelection::top_left, {}}};
    const ClothModel cloth = build_cloth(scene);
    for (const std::string name : all_solvers) {
        NewtonProblem problem(cloth, 0.05);
        const auto solver = make_assembled_solver(cloth, name, chosen_instruction_set(), 1);
        solver->linearise(problem.x(), inverse_tau, problem.blocks);
        const LinearReport report = solver->solve(problem.right(), 1e-5, 20000, problem.d.view());
        EXPECT_TRUE(report.converged) << name;
        EXPECT_LE(residual_of(problem), 1.1e-5) << name;
    }
}

TEST(AssembledSolver, OfNoRightSideIsZero) {
    const NewtonSheet sheet = grid_sheet(9, 7, true);
    NewtonProblem problem(sheet.cloth);
    problem.r.fill_zero();
    problem.r.set(0, {1.0, 1.0, 1.0});  // pinned: not read
    for (const std::string name : all_solvers) {
        const auto solver = make_assembled_solver(sheet.cloth, name, chosen_instruction_set(), 1);
        solver->linearise(problem.x(), inverse_tau, problem.blocks);
        disturb(sheet.cloth, problem.d, 1.0, 3);
        const LinearReport report = solver->solve(problem.right(), 1e-6, 100, problem.d.view());
        EXPECT_TRUE(report.converged);
        EXPECT_EQ(report.iterations, 0);
        EXPECT_EQ(report.residual, 0.0);
        EXPECT_EQ(norm(problem.d), 0.0);
    }
}

TEST(AssembledSolver, OfAClothOfPinsIsZero) {
    NewtonSheet sheet = grid_sheet(3, 3, false);
    for (std::uint32_t p = 0; p < 9; ++p) pin_at_rest(sheet.cloth, p);
    NewtonProblem problem(sheet.cloth);
    for (const std::string name : all_solvers) {
        const auto solver = make_assembled_solver(sheet.cloth, name, chosen_instruction_set(), 1);
        solver->linearise(problem.x(), inverse_tau, problem.blocks);
        EXPECT_TRUE(solver->solve(problem.right(), 1e-6, 100, problem.d.view()).converged);
        EXPECT_EQ(norm(problem.d), 0.0);
    }
}

TEST(AssembledSolver, SaysThatItDidNotConverge) {
    const NewtonSheet sheet = grid_sheet(33, 33, true);
    for (const std::string name : {"jacobi", "aggregation"}) {
        NewtonProblem problem(sheet.cloth);
        const auto solver = make_assembled_solver(sheet.cloth, name, chosen_instruction_set(), 1);
        solver->linearise(problem.x(), inverse_tau, problem.blocks);
        const LinearReport report = solver->solve(problem.right(), 1e-8, 5, problem.d.view());
        EXPECT_FALSE(report.converged);
        EXPECT_EQ(report.iterations, 5);
        EXPECT_GT(report.residual, 1e-8);
        EXPECT_LE(report.residual, 1.0);
        EXPECT_NEAR(residual_of(problem), report.residual, 1e-6);
    }
}

TEST(AssembledSolver, LeavesNothingWhereNothingCanBeSolved) {
    const NewtonSheet sheet = grid_sheet(9, 7, true);
    for (const std::string name : all_solvers) {
        const auto solver = make_assembled_solver(sheet.cloth, name, chosen_instruction_set(), 1);
        NewtonProblem problem(sheet.cloth);
        problem.r.set(sheet.cloth.slot(20), {std::nan(""), 0.0, 0.0});
        solver->linearise(problem.x(), inverse_tau, problem.blocks);
        EXPECT_FALSE(solver->solve(problem.right(), 1e-6, 100, problem.d.view()).converged);
        EXPECT_EQ(norm(problem.d), 0.0) << name;
        NewtonProblem negative(sheet.cloth, -50.0);
        solver->linearise(negative.x(), inverse_tau, negative.blocks);
        const LinearReport report = solver->solve(negative.right(), 1e-6, 100, negative.d.view());
        EXPECT_FALSE(report.converged) << name;
        EXPECT_EQ(report.residual, 1.0) << name;
        EXPECT_EQ(norm(negative.d), 0.0) << name;
    }
}

TEST(AssembledSolver, FollowsTheMatrix) {
    const NewtonSheet sheet = grid_sheet(9, 7, true);
    for (const std::string name : all_solvers) {
        const auto solver = make_assembled_solver(sheet.cloth, name, chosen_instruction_set(), 1);
        for (const double own : {1.0, 100.0, 0.1}) {
            NewtonProblem problem(sheet.cloth, own);
            solver->linearise(problem.x(), inverse_tau, problem.blocks);
            EXPECT_TRUE(solver->solve(problem.right(), 1e-6, 1000, problem.d.view()).converged);
            EXPECT_LE(residual_of(problem), 1e-6);
        }
    }
}

// One frame of 1/60 s at 1 m and k = 1000 N/m: with cells a quarter as wide, block Jacobi takes
// four times the iterations.
TEST(AssembledSolver, AggregationNeedsNoMoreIterationsOnFinerMeshes) {
    std::vector<int> iterations, by_jacobi;
    for (const std::uint32_t size : {50u, 100u, 200u}) {
        const NewtonSheet sheet =
            mesh_sheet(sheet_mesh(size, size, 1.0 / (size - 1), true), "triangles", true);
        NewtonProblem problem(sheet.cloth);
        for (const std::string name : {"aggregation", "jacobi"}) {
            const auto solver =
                make_assembled_solver(sheet.cloth, name, chosen_instruction_set(), 1);
            solver->linearise(problem.x(), inverse_tau, problem.blocks);
            const LinearReport report =
                solver->solve(problem.right(), 1e-3, 5000, problem.d.view());
            EXPECT_TRUE(report.converged);
            (name == "jacobi" ? by_jacobi : iterations).push_back(report.iterations);
        }
    }
    for (const int count : iterations) EXPECT_LE(count, 17);  // 20 of a plain V-cycle
    EXPECT_LE(iterations[2], iterations[0] + 1);
    EXPECT_GT(by_jacobi[2], 10 * iterations[2]);
}

TEST(AssembledSolver, GivesTheSameBitsOfAnyNumberOfThreads) {
    const NewtonSheet sheet = mesh_sheet(sheet_mesh(140, 130, 1.0 / 139, true), "triangles", true);
    for (const std::string name : {"jacobi", "aggregation"}) {
        std::vector<Vec3Array<double>> solutions;
        for (const int threads : {1, 2, 7}) {
            NewtonProblem problem(sheet.cloth);
            ThreadTeam(threads).run([&] {
                const auto solver =
                    make_assembled_solver(sheet.cloth, name, chosen_instruction_set(), threads);
                solver->linearise(problem.x(), inverse_tau, problem.blocks);
                solver->solve(problem.right(), 1e-2, 200, problem.d.view());
            });
            solutions.push_back(problem.d);
        }
        EXPECT_GT(norm(solutions[0]), 0.0);
        for (std::size_t n = 1; n < solutions.size(); ++n) {
            for (std::size_t i = 0; i < solutions[0].data_size(); ++i) {
                ASSERT_EQ(solutions[n].data()[i], solutions[0].data()[i]) << name;
            }
        }
    }
}

}  // namespace
}  // namespace weft::test
