// The kernels of a grid's multigrid solver: its matrix against the readable products of
// forces/linearised.h, the rest against what they stand for, and against their twins.
#include "forces/newton_pass.h"

#include <gtest/gtest.h>

#include "forces/grid_multigrid_cycle.h"
#include "support/newton_sheets.h"

namespace weft::test {
namespace {

TEST(NewtonPass, MultipliesByNewtonsMatrix) {
    for (const Sheet& sheet : sheets()) {
        const Vec3Array<double> x = some_positions(sheet.cloth);
        const Vec3Array<double> u = random_field<double>(sheet.cloth, 3);
        const Vec3Array<float> operand = random_field<float>(sheet.cloth, 3);
        for (const bool air : {false, true}) {
            const SymmetricBlocks<double> blocks = some_blocks(sheet.cloth, air);
            const auto expected = expected_product(sheet.cloth, x.view(), blocks, u);
            for (const InstructionSet set : all_sets()) {
                MultigridCycle cycle(sheet.cloth, newton_kernels(set), 1);
                cycle.linearise(x.view(), inverse_tau, blocks);
                Vec3Array<float> found(x.size());
                const double product = cycle.finest().multiply(operand, found);
                const double size = length_of(expected);
                EXPECT_LT(distance_of(expected, found), 1e-5 * size)
                    << sheet.name << " " << sheet.cloth.shape.columns << " x "
                    << sheet.cloth.shape.rows << " " << name_of(set);
                EXPECT_NEAR(product, dot_of(u, expected), 1e-5 * size * length_of(u));
            }
        }
    }
}

// D (D^-1 b) = b, with D's block of a particle from the matrix's products with unit vectors.
TEST(NewtonPass, SolvesWithItsDiagonalBlocks) {
    const ClothModel cloth = build_cloth(damped_scene(19, 4));
    const Vec3Array<double> x = some_positions(cloth);
    const SymmetricBlocks<double> blocks = some_blocks(cloth, true);
    const Eigen::MatrixXd matrix = dense_matrix(cloth, x.view(), blocks);
    for (const InstructionSet set : all_sets()) {
        MultigridCycle cycle(cloth, newton_kernels(set), 1);
        cycle.linearise(x.view(), inverse_tau, blocks);
        const Vec3Array<double> b = random_field<double>(cloth, 8);
        cycle.finest().b = random_field<float>(cloth, 8);
        cycle.finest().start(0.5f);
        for (std::size_t s = 0; s < b.size(); ++s) {
            const auto place = static_cast<Eigen::Index>(3 * s);
            const Eigen::Matrix3d block = matrix.block<3, 3>(place, place);
            const Eigen::Vector3d expected = 0.5 * block.llt().solve(as_dense(b).segment<3>(place));
            const Vec3d u = vec3_cast<double>(cycle.finest().u[s]);
            EXPECT_LT((Eigen::Vector3d(u.x, u.y, u.z) - expected).norm(),
                      1e-4 * expected.norm() + 1e-30)
                << name_of(set) << " slot " << s;
        }
    }
}

// u + omega D^-1 (b - A u), in place or not, is what the twins say.
TEST(NewtonPass, SmoothsAsItsTwins) {
    for (const Sheet& sheet : sheets()) {
        const Vec3Array<double> x = some_positions(sheet.cloth);
        for (const bool air : {false, true}) {
            const SymmetricBlocks<double> blocks = some_blocks(sheet.cloth, air);
            Vec3Array<float> expected;
            double product = 0.0;
            for (const InstructionSet set : all_sets()) {
                MultigridCycle cycle(sheet.cloth, newton_kernels(set), 1);
                cycle.linearise(x.view(), inverse_tau, blocks);
                MultigridLevel& level = cycle.finest();
                level.b = random_field<float>(sheet.cloth, 4);
                level.start(0.6f);
                const double found = level.smooth(0.6f);
                if (set == InstructionSet::scalar) {
                    expected = level.u;
                    product = found;
                }
                EXPECT_LT(distance_of(expected, level.u), 1e-5 * length_of(expected))
                    << sheet.name << " " << sheet.cloth.shape.columns << " x "
                    << sheet.cloth.shape.rows << " " << name_of(set);
                EXPECT_NEAR(found, product, 1e-5 * length_of(expected) * length_of(level.b));
            }
        }
    }
}

// (P u, v) = (u, P^T v), linear functions are interpolated exactly, constants summed up.
TEST(NewtonPass, RestrictsByTheTransposeOfLinearInterpolation) {
    for (const std::size_t fine : {2u, 5u, 6u, 8u, 9u, 17u, 33u, 34u, 50u, 64u, 65u, 100u, 129u}) {
        const std::size_t coarse = fine > 5 ? (fine + 1) / 2 : fine;
        constexpr std::size_t fine_rows = 12, coarse_rows = 6;
        const ParticleLayout finer = ParticleLayout::of_grid(fine, fine_rows);
        const ParticleLayout coarser = ParticleLayout::of_grid(coarse, coarse_rows);
        const MultigridTransfer transfer(fine, fine_rows, finer.row_stride(), coarse, coarse_rows,
                                         coarser.row_stride());
        Vec3Array<float> v(finer.slot_count()), pu(finer.slot_count()), free(finer.slot_count());
        Vec3Array<float> u(coarser.slot_count()), rv(coarser.slot_count());
        finer.for_each([&](std::size_t p, std::size_t slot) {
            v.set(slot, vec3_cast<float>(random_vector(1, p)));
            free.set(slot, {1, 1, 1});
        });
        coarser.for_each([&](std::size_t p, std::size_t slot) {
            const double i = static_cast<double>(p % coarse) / static_cast<double>(coarse - 1);
            const double j = static_cast<double>(p / coarse) / (coarse_rows - 1);
            u.set(slot, {static_cast<float>(random_vector(2, p).x),
                         static_cast<float>(1 + i - 3 * j), 0});
        });
        std::vector<float> lines(NewtonBand::line_count *
                                 NewtonBand::line_stride(finer.row_stride()));
        for (const InstructionSet set : all_sets()) {
            const NewtonKernels& kernels = newton_kernels(set);
            pu.fill_zero();
            rv.fill_zero();
            const NewtonBand fine_band{0, fine_rows, lines.data()};
            const NewtonBand coarse_band{0, coarse_rows, lines.data()};
            const float* const all = free.view().x;
            kernels.interpolate(transfer.tables(), fine_band, u.view().x, all, pu.view().x);
            kernels.interpolate(transfer.tables(), fine_band, u.view().y, all, pu.view().y);
            kernels.coarsen(transfer.tables(), coarse_band, v.view().x, rv.view().x);
            kernels.coarsen(transfer.tables(), coarse_band, free.view().y, rv.view().y);
            const auto x_only = [](Vec3Array<float> field) {
                for (std::size_t s = 0; s < field.size(); ++s) field.set(s, {field[s].x, 0, 0});
                return field;
            };
            EXPECT_NEAR(dot_of(x_only(pu), x_only(v)), dot_of(x_only(u), x_only(rv)), 1e-4)
                << fine << " " << name_of(set);
            double total = 0.0, padding = 0.0;
            for (std::size_t s = 0; s < rv.size(); ++s) total += static_cast<double>(rv[s].y);
            EXPECT_NEAR(total, static_cast<double>(fine * fine_rows), 1e-2);
            for (std::size_t s = 0; s < pu.size(); ++s) {
                if (free[s].x == 0.0f) padding += static_cast<double>(std::abs(pu[s].x));
            }
            EXPECT_EQ(padding, 0.0);
            finer.for_each([&](std::size_t p, std::size_t slot) {
                const double i = static_cast<double>(p % fine) / static_cast<double>(fine - 1);
                const double j = static_cast<double>(p / fine) / (fine_rows - 1);
                EXPECT_NEAR(pu[slot].y, 1 + i - 3 * j, 2e-6) << fine << " " << name_of(set);
            });
        }
    }
}

}  // namespace
}  // namespace weft::test
