// Springs as couplings of Newton's matrix against the readable products of forces/linearised.h.
#include <gtest/gtest.h>

#include "forces/assembled_springs.h"
#include "math/block_kernel.h"
#include "support/newton_problems.h"

namespace weft::test {
namespace {

std::vector<Vec3d> rest_places(const ClothModel& cloth) {
    std::vector<Vec3d> places(cloth.layout.slot_count());
    cloth.layout.for_each(
        [&](std::size_t p, std::size_t slot) { places[slot] = cloth.rest_position(p); });
    return places;
}

TEST(AssembledSprings, MultiplyAsTheReadableProducts) {
    for (const NewtonSheet& sheet : small_sheets()) {
        for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
            SCOPED_TRACE(sheet.name + " " + std::string(instruction_sets()[set]));
            NewtonProblem problem(sheet.cloth);
            const std::size_t slots = problem.r.size();
            AssembledSprings springs(spring_network(sheet.cloth), rest_places(sheet.cloth),
                                     static_cast<InstructionSet>(set));
            springs.linearise(problem.x(), inverse_tau, problem.blocks);
            Vec3Array<double> u(slots), left(slots);
            disturb(sheet.cloth, u, 1.0, 2);
            u = masked(problem, u);
            const Vec3Array<double> expected = product(problem, u);
            // In double, from 0 - A u.
            const Vec3Array<double> zero(slots);
            const double size = springs.residual(zero.view(), std::as_const(u).view(), left.view());
            for (std::size_t s = 0; s < slots; ++s) left.set(s, -left[s]);
            EXPECT_LT(norm(difference(left, expected)), 1e-13 * norm(expected));
            EXPECT_NEAR(size, norm(expected), 1e-13 * size);
            // In float, assembled.
            BlockMatrix matrix(springs.pattern(), BlockForm::spring);
            springs.assemble(matrix);
            const std::size_t slices = springs.pattern().slices();
            BlockVector v(slices, true), out(slices, false);
            for (std::size_t s = 0; s < slots; ++s) v.set(s, u[s]);
            BlockKernel(slices, static_cast<InstructionSet>(set)).product(matrix, v, out);
            Vec3Array<double> found(slots);
            for (std::size_t s = 0; s < slots; ++s) found.set(s, out[s]);
            EXPECT_LT(norm(difference(found, expected)), 1e-6 * norm(expected));
        }
    }
}

// Two particles at one place have no direction and no force between them.
TEST(AssembledSprings, OfASpringWithoutLengthAreNothing) {
    const NewtonSheet sheet = grid_sheet(5, 4, false);
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        NewtonProblem problem(sheet.cloth);
        problem.state.x.set(sheet.cloth.slot(1), problem.state.x[sheet.cloth.slot(2)]);
        AssembledSprings springs(spring_network(sheet.cloth), rest_places(sheet.cloth),
                                 static_cast<InstructionSet>(set));
        springs.linearise(problem.x(), inverse_tau, problem.blocks);
        Vec3Array<double> left(problem.r.size());
        const Vec3Array<double> zero(problem.r.size());
        springs.residual(zero.view(), problem.right(), left.view());
        const Vec3Array<double> expected = product(problem, problem.r);
        for (std::size_t s = 0; s < left.size(); ++s) left.set(s, -left[s]);
        EXPECT_LT(norm(difference(left, expected)), 1e-13 * norm(expected));
    }
}

}  // namespace
}  // namespace weft::test
