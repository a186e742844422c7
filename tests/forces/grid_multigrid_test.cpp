// The grid's multigrid solver: its coarser sheets, its V-cycle, and its solutions.
#include "forces/grid_multigrid.h"

#include <gtest/gtest.h>

#include <limits>

#include "forces/grid_multigrid_cycle.h"
#include "math/parallel.h"
#include "support/newton_sheets.h"

namespace weft::test {
namespace {

// Half the stretch energy of a sheet per unit strain squared is what springs along x hold.
TEST(GridMultigridLevel, CoarserSheetsKeepTheModuli) {
    for (const StiffnessPer per : {StiffnessPer::spring, StiffnessPer::width}) {
        for (const auto& [columns, rows] : {std::pair{33, 17}, {50, 37}, {9, 130}}) {
            SceneDescription scene = damped_scene(columns, rows);
            scene.material.stiffness_per = per;
            MultigridSheet sheet = finest_sheet(build_cloth(scene));
            const auto energy = [](const MultigridSheet& of, std::size_t n) {
                const GridShape shape{of.columns, of.rows, 0, 0};
                const GridSpringFamily& family = of.families[n];
                double sum = 0.0;
                for (std::size_t j = 0; j < family.owner_rows; ++j) {
                    for (std::size_t i = 0; i < family.owner_columns; ++i) {
                        sum += family.spring_factor(i, j, shape) * family.rest_length *
                               family.rest_length;
                    }
                }
                return sum;
            };
            const double along = energy(sheet, 0), down = energy(sheet, 1);
            while (const auto coarser = coarser_sheet(sheet)) {
                sheet = *coarser;
                EXPECT_NEAR(energy(sheet, 0), along, 1e-12 * along);
                EXPECT_NEAR(energy(sheet, 1), down, 1e-12 * down);
                // Of shear: k (dx dy / L)^2 a cell.
                const double dx = sheet.families[0].rest_length, dy = sheet.families[1].rest_length;
                EXPECT_NEAR(sheet.families[2].rest_length, std::hypot(dx, dy), 1e-12);
            }
            EXPECT_LE(std::min(sheet.columns, sheet.rows), 5u);
        }
    }
}

TEST(GridMultigridCycle, IsSymmetricAndPositive) {
    for (const Sheet& sheet : sheets()) {
        const Vec3Array<double> x = some_positions(sheet.cloth);
        for (const InstructionSet set : {InstructionSet::scalar, chosen_instruction_set()}) {
            MultigridCycle cycle(sheet.cloth, newton_kernels(set), 1);
            cycle.linearise(x.view(), inverse_tau, some_blocks(sheet.cloth, true));
            ASSERT_TRUE(cycle.valid());
            std::array<Vec3Array<float>, 2> b, u;
            for (std::size_t n = 0; n < 2; ++n) {
                b[n] = cycle.finest().b = random_field<float>(sheet.cloth, 20 + n);
                const double product = cycle.apply();
                u[n] = cycle.finest().u;
                EXPECT_NEAR(product, dot_of(b[n], u[n]), 1e-5 * length_of(b[n]) * length_of(u[n]));
                EXPECT_GE(product, 0.0);
            }
            EXPECT_NEAR(dot_of(b[0], u[1]), dot_of(b[1], u[0]),
                        1e-5 * length_of(b[0]) * length_of(u[1]))
                << sheet.name << " " << sheet.cloth.shape.columns << " " << name_of(set);
        }
    }
}

TEST(GridMultigrid, SolvesAsADenseFactorisation) {
    for (const auto& [columns, rows] : {std::pair{2, 2}, {9, 7}, {12, 3}, {14, 11}}) {
        SceneDescription scene = damped_scene(columns, rows);
        for (const auto& pins : {std::vector<EdgeSelection>{},
                                 {EdgeSelection::top_left},
                                 {EdgeSelection::left_edge}}) {
            scene.pins.clear();
            for (const EdgeSelection edge : pins) scene.pins.push_back({edge, {}});
            const ClothModel cloth = build_cloth(scene);
            const Vec3Array<double> x = disturbed_state<double>(cloth, 0.05).x;
            const SymmetricBlocks<double> blocks = some_blocks(cloth, true);
            Vec3Array<double> r = random_field<double>(cloth, 6), d(r.size());
            const Eigen::VectorXd expected =
                dense_matrix(cloth, x.view(), blocks).ldlt().solve(as_dense(r));
            for (const Pin& pin : cloth.pins) {
                r.set(cloth.slot(pin.particle), {1e9, 1e9, std::nan("")});
            }
            for (const InstructionSet set : all_sets()) {
                const auto solver = make_grid_multigrid(cloth, set, 1);
                EXPECT_EQ(solver->name(), "multigrid");
                solver->linearise(x.view(), inverse_tau, blocks);
                const LinearReport report = solver->solve(r.view(), 1e-6, 100, d.view());
                EXPECT_TRUE(report.converged);
                EXPECT_LE(report.residual, 1e-6);
                EXPECT_LT((as_dense(d) - expected).norm(), 1e-4 * expected.norm())
                    << columns << " x " << rows << " " << name_of(set);
                for (const Pin& pin : cloth.pins) {
                    EXPECT_EQ(length(d[cloth.slot(pin.particle)]), 0.0);
                }
            }
        }
    }
}

// A stretched, waving sheet of 1 m and 0.2 kg.
ClothModel waving_sheet(int columns, int rows, const std::vector<EdgeSelection>& pins,
                        Vec3Array<double>& x) {
    const double cell = 1.0 / (std::max(columns, rows) - 1);
    SceneDescription scene = bare_sheet(columns, rows, cell * (columns - 1), cell * (rows - 1));
    scene.material.structural.stiffness = 1e3;
    scene.material.shear.stiffness = 5e2;
    scene.material.bend.stiffness = 1e2;
    for (const EdgeSelection edge : pins) scene.pins.push_back({edge, {}});
    ClothModel cloth = build_cloth(scene);
    x = rest_state<double>(cloth).x;
    cloth.layout.for_each([&](std::size_t, std::size_t slot) {
        const Vec3d at = x[slot];
        x.set(slot, 1.01 * at + Vec3d{0.0, 0.0, 0.1 * std::sin(7.0 * at.x + 4.0 * at.y)});
    });
    return cloth;
}

int iterations_of(const ClothModel& cloth, const Vec3Array<double>& x) {
    const auto solver = make_grid_multigrid(cloth, chosen_instruction_set(), 1);
    solver->linearise(x.view(), inverse_tau, some_blocks(cloth, false));
    const Vec3Array<double> r = random_field<double>(cloth, 2);
    Vec3Array<double> d(r.size());
    const LinearReport report = solver->solve(r.view(), 1e-5, 500, d.view());
    EXPECT_TRUE(report.converged);
    return report.iterations;
}

TEST(GridMultigrid, NeedsNoMoreIterationsOnFinerGrids) {
    using enum EdgeSelection;
    using Pins = std::vector<EdgeSelection>;
    for (const Pins& pins : {Pins{top_left, top_right}, Pins{top_left}, Pins{left_edge}, Pins{}}) {
        for (const auto& [columns, rows] : {std::pair{33, 33},
                                            {65, 65},
                                            {129, 129},
                                            {257, 257},
                                            {128, 128},
                                            {50, 37},
                                            {300, 7},
                                            {2, 150}}) {
            Vec3Array<double> x;
            const ClothModel cloth = waving_sheet(columns, rows, pins, x);
            const int iterations = iterations_of(cloth, x);
            EXPECT_LE(iterations, 18) << columns << " x " << rows << ", " << pins.size();
        }
    }
}

// Scattered pins, most of them between the nodes of the next coarser level.
TEST(GridMultigrid, NeedsFewIterationsWithPinsInside) {
    Vec3Array<double> x;
    ClothModel cloth = waving_sheet(65, 65, {}, x);
    for (const std::uint32_t p : {33u * 65 + 33, 10u * 65 + 21, 51u * 65 + 7})
        pin_at_rest(cloth, p);
    EXPECT_LE(iterations_of(cloth, x), 24);
}

// Springs along one direction 25 times as stiff as those along the other.
TEST(GridMultigrid, NeedsFewIterationsOnUnevenCells) {
    for (const double height : {0.2, 5.0}) {
        SceneDescription scene = damped_scene(65, 65);
        scene.cloth.grid.size = {1.0, height};
        const ClothModel cloth = build_cloth(scene);
        Vec3Array<double> x = rest_state<double>(cloth).x;
        for (std::size_t s = 0; s < x.size(); ++s) x.set(s, 1.01 * x[s]);
        EXPECT_LE(iterations_of(cloth, x), 35) << height;
    }
}

TEST(GridMultigrid, ZeroGivesZero) {
    const ClothModel cloth = build_cloth(damped_scene(20, 9));
    const auto solver = make_grid_multigrid(cloth, chosen_instruction_set(), 1);
    const Vec3Array<double> x = some_positions(cloth);
    solver->linearise(x.view(), inverse_tau, some_blocks(cloth, false));
    const Vec3Array<double> r(x.size());
    Vec3Array<double> d = random_field<double>(cloth, 1);
    const LinearReport report = solver->solve(r.view(), 1e-3, 10, d.view());
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 0);
    EXPECT_EQ(length_of(d), 0.0);
}

TEST(GridMultigrid, SaysWhenItDidNotConverge) {
    Vec3Array<double> x;
    const ClothModel cloth = waving_sheet(40, 40, {EdgeSelection::top_left}, x);
    const auto solver = make_grid_multigrid(cloth, chosen_instruction_set(), 1);
    solver->linearise(x.view(), inverse_tau, some_blocks(cloth, false));
    Vec3Array<double> r = random_field<double>(cloth, 2), d(r.size());
    const LinearReport report = solver->solve(r.view(), 1e-5, 2, d.view());
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.iterations, 2);
    EXPECT_GT(report.residual, 1e-5);
    EXPECT_LT(report.residual, 1.0);
    EXPECT_GT(length_of(d), 0.0);
    r.set(cloth.slot(777), {0.0, std::numeric_limits<double>::infinity(), 0.0});
    EXPECT_FALSE(solver->solve(r.view(), 1e-5, 20, d.view()).converged);
    EXPECT_EQ(length_of(d), 0.0);
}

TEST(GridMultigrid, SaysWhenTheMatrixCannotBeFactored) {
    const ClothModel cloth = build_cloth(damped_scene(20, 9));
    const auto solver = make_grid_multigrid(cloth, chosen_instruction_set(), 1);
    Vec3Array<double> x = some_positions(cloth);
    x.set(cloth.slot(50), {0.0, std::nan(""), 0.0});
    solver->linearise(x.view(), inverse_tau, some_blocks(cloth, false));
    const Vec3Array<double> r = random_field<double>(cloth, 1);
    Vec3Array<double> d = random_field<double>(cloth, 2);
    EXPECT_FALSE(solver->solve(r.view(), 1e-3, 10, d.view()).converged);
    for (std::size_t s = 0; s < d.size(); ++s) ASSERT_TRUE(std::isfinite(length(d[s])));
}

// Tiny and huge right sides are scaled: the solution is in proportion.
TEST(GridMultigrid, IsLinearInTheRightSide) {
    const ClothModel cloth = build_cloth(damped_scene(20, 9));
    const auto solver = make_grid_multigrid(cloth, chosen_instruction_set(), 1);
    const Vec3Array<double> x = some_positions(cloth);
    solver->linearise(x.view(), inverse_tau, some_blocks(cloth, false));
    const Vec3Array<double> r = random_field<double>(cloth, 2);
    Vec3Array<double> d(r.size()), scaled_r(r.size()), scaled_d(r.size());
    ASSERT_TRUE(solver->solve(r.view(), 1e-6, 100, d.view()).converged);
    for (const double scale : {1e-200, 1e-30, 1e-8, 1e20, 1e60}) {
        for (std::size_t s = 0; s < r.size(); ++s) scaled_r.set(s, scale * r[s]);
        ASSERT_TRUE(solver->solve(scaled_r.view(), 1e-6, 100, scaled_d.view()).converged) << scale;
        for (std::size_t s = 0; s < r.size(); ++s) scaled_d.set(s, scaled_d[s] / scale);
        EXPECT_LT(distance_of(d, scaled_d), 1e-4 * length_of(d)) << scale;
    }
}

TEST(GridMultigrid, ThreadsDoNotChangeTheSolution) {
    Vec3Array<double> x;
    const ClothModel cloth = waving_sheet(250, 181, {EdgeSelection::top_left}, x);
    const Vec3Array<double> r = random_field<double>(cloth, 2);
    const SymmetricBlocks<double> blocks = some_blocks(cloth, true);
    Vec3Array<double> expected(r.size()), found(r.size());
    for (const int threads : {1, 2, 7}) {
        ThreadTeam team(threads);
        team.run([&] {
            const auto solver = make_grid_multigrid(cloth, chosen_instruction_set(), threads);
            solver->linearise(x.view(), inverse_tau, blocks);
            solver->solve(r.view(), 1e-3, 50, found.view());
        });
        if (threads == 1) expected = found;
        EXPECT_EQ(different_bits(expected, found), 0u) << threads;
    }
    EXPECT_GT(length_of(expected), 0.0);
}

}  // namespace
}  // namespace weft::test
