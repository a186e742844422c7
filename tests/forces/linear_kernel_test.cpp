// Fast products with the stiffness and damping matrices against their readable twins.
#include <gtest/gtest.h>

#include <vector>

#include "forces/linear_kernel.h"
#include "forces/linearised.h"
#include "math/parallel.h"
#include "support/cloth_forces.h"

namespace weft::test {
namespace {

struct Sheet {
    const char* name;
    ClothModel cloth;
    ForcesDescription forces;
};

// Dashpots, drag, uneven cells, masses and widths, two pins.
SceneDescription damped_scene(int columns, int rows) {
    SceneDescription scene = bare_sheet(columns, rows, 1.0, 0.6);
    add_dashpots(scene, 3e-3);
    scene.material.shear.damping *= 2;
    scene.material.stiffness_per = StiffnessPer::width;
    scene.forces.damping = 0.02;
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::bottom_right, {}}};
    return scene;
}

std::vector<Sheet> sheets() {
    std::vector<Sheet> result;
    const auto add = [&](const char* name, const SceneDescription& scene) {
        result.push_back({name, build_cloth(scene), scene.forces});
    };
    for (const auto& [columns, rows] : {std::pair{2, 2},
                                        {3, 2},
                                        {2, 9},
                                        {5, 3},
                                        {16, 4},
                                        {17, 5},
                                        {18, 3},
                                        {19, 7},
                                        {31, 33},
                                        {34, 2},
                                        {35, 6},
                                        {67, 11}}) {
        add("width", damped_scene(columns, rows));
    }
    SceneDescription spring = damped_scene(21, 13);
    spring.material.stiffness_per = StiffnessPer::spring;
    add("spring", spring);
    SceneDescription border = damped_scene(23, 9);
    border.material.bend_layout = BendLayout::border;
    add("border", border);
    for (const int columns : {2, 5, 17, 40}) {
        for (const StiffnessPer per : {StiffnessPer::spring, StiffnessPer::width}) {
            SceneDescription mesh = damped_scene(columns, 7);
            mesh.material.stiffness_per = per;
            mesh.pins = {{ParticleSelection{{0, 5}}, {}}};
            make_mesh_of_grid(mesh);
            add("mesh", mesh);
            shuffle_layout(result.back().cloth);
        }
    }
    return result;
}

template <typename Real>
class LinearKernelOf : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(LinearKernelOf, Precisions);

constexpr double tolerance_of(std::size_t size) {
    return size == 4 ? 1e-5 : 1e-13;
}

template <typename Real>
double length_of(const Vec3Array<Real>& array) {
    double sum = 0.0;
    for (std::size_t s = 0; s < array.size(); ++s) {
        sum += dot(vec3_cast<double>(array[s]), vec3_cast<double>(array[s]));
    }
    return std::sqrt(sum);
}

TYPED_TEST(LinearKernelOf, EqualsItsTwinOnEverySheetAndInstructionSet) {
    const double tolerance = tolerance_of(sizeof(TypeParam));
    for (const Sheet& sheet : sheets()) {
        const std::size_t slots = sheet.cloth.layout.slot_count();
        auto state = disturbed_state<TypeParam>(sheet.cloth, 0.05);
        state.x.set(sheet.cloth.slot(1), state.x[sheet.cloth.slot(2)]);  // a spring of no length
        Vec3Array<TypeParam> expected(slots), found(slots);
        LinearKernel<TypeParam> twin(sheet.cloth, sheet.forces, InstructionSet::scalar, 1);
        twin.linearise_at(std::as_const(state.x).view());
        for (std::size_t set = 1; set < instruction_sets().size(); ++set) {
            LinearKernel<TypeParam> kernel(sheet.cloth, sheet.forces,
                                           static_cast<InstructionSet>(set), 1);
            kernel.linearise_at(std::as_const(state.x).view());
            for (const LinearMatrix matrix : {LinearMatrix::stiffness, LinearMatrix::damping}) {
                const auto u = std::as_const(state.v).view();
                const LinearSums sums = twin.multiply(matrix, 0.7, u, expected.view());
                const LinearSums got = kernel.multiply(matrix, 0.7, u, found.view());
                const double size = length_of(expected);
                for (std::size_t s = 0; s < slots; ++s) {
                    const auto error = vec3_cast<double>(found[s]) - vec3_cast<double>(expected[s]);
                    ASSERT_LT(length(error), tolerance * size)
                        << sheet.name << " " << sheet.cloth.shape.columns << " slot " << s << " "
                        << instruction_sets()[set];
                }
                EXPECT_NEAR(got.in_out, sums.in_out, tolerance * size * length_of(state.v));
                EXPECT_NEAR(got.out_out, sums.out_out, tolerance * size * size);
                EXPECT_GT(sums.in_out, 0.0);
            }
        }
    }
}

// M^-1/2 K M^-1/2 u by the functions of forces/linearised.h.
TEST(LinearKernelTwin, ScalesByTheRootOfMasses) {
    const SceneDescription scene = damped_scene(6, 5);
    const ClothModel cloth = build_cloth(scene);
    const auto state = disturbed_state<double>(cloth, 0.05);
    LinearKernel<double> kernel(cloth, scene.forces, InstructionSet::scalar, 1);
    kernel.linearise_at(state.x.view());
    Vec3Array<double> u = state.v, expected(cloth.layout.slot_count()), found = expected;
    const auto root = [&](std::size_t p) {
        return p == 0 || p + 1 == cloth.particle_count ? 0.0 : 1 / std::sqrt(cloth.masses[p]);
    };
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        u.set(slot, root(p) * u[slot]);
        EXPECT_DOUBLE_EQ(kernel.root_inverse_masses()[slot], root(p));
    });
    stiffness_product<double>(cloth, state.x.view(), std::as_const(u).view(), expected.view());
    kernel.multiply(LinearMatrix::stiffness, 1.0, state.v.view(), found.view());
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        EXPECT_LT(length(found[slot] - root(p) * expected[slot]), 1e-12 * length_of(found));
    });
}

TYPED_TEST(LinearKernelOf, LeavesPinsAndPaddingAtZero) {
    for (const Sheet& sheet : sheets()) {
        const auto state = disturbed_state<TypeParam>(sheet.cloth, 0.05);
        Vec3Array<TypeParam> out(sheet.cloth.layout.slot_count());
        for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
            LinearKernel<TypeParam> kernel(sheet.cloth, sheet.forces,
                                           static_cast<InstructionSet>(set), 1);
            kernel.linearise_at(state.x.view());
            for (const LinearMatrix matrix : {LinearMatrix::stiffness, LinearMatrix::damping}) {
                kernel.multiply(matrix, 1.0, state.v.view(), out.view());
                for (const Pin& pin : sheet.cloth.pins) {
                    EXPECT_EQ(length(out[sheet.cloth.slot(pin.particle)]), TypeParam{0});
                }
                Vec3Array<TypeParam> particles = out;
                sheet.cloth.layout.for_each(
                    [&](std::size_t, std::size_t slot) { particles.set(slot, {}); });
                for (std::size_t i = 0; i < particles.data_size(); ++i) {
                    ASSERT_EQ(particles.data()[i], TypeParam{0}) << sheet.name << " " << i;
                }
            }
        }
    }
}

// Of a grid and a mesh large enough to be shared by threads.
TYPED_TEST(LinearKernelOf, GivesTheSameBitsOfAnyNumberOfThreads) {
    for (const bool as_mesh : {false, true}) {
        SceneDescription scene = damped_scene(211, 307);
        if (as_mesh) {
            scene.pins.clear();
            make_mesh_of_grid(scene);
        }
        const ClothModel cloth = build_cloth(scene);
        const auto state = disturbed_state<TypeParam>(cloth, 0.001);
        for (std::size_t set = 1; set < instruction_sets().size(); ++set) {
            std::vector<Vec3Array<TypeParam>> products;
            std::vector<LinearSums> sums;
            for (const int threads : {1, 2, 7}) {
                ThreadTeam team(threads);
                Vec3Array<TypeParam> out(cloth.layout.slot_count());
                team.run([&] {
                    LinearKernel<TypeParam> kernel(cloth, scene.forces,
                                                   static_cast<InstructionSet>(set), threads);
                    kernel.linearise_at(state.x.view());
                    sums.push_back(
                        kernel.multiply(LinearMatrix::stiffness, 0.3, state.v.view(), out.view()));
                });
                products.push_back(std::move(out));
            }
            for (std::size_t n = 1; n < products.size(); ++n) {
                EXPECT_EQ(sums[n].in_out, sums[0].in_out);
                EXPECT_EQ(sums[n].out_out, sums[0].out_out);
                for (std::size_t i = 0; i < products[0].data_size(); ++i) {
                    ASSERT_EQ(products[n].data()[i], products[0].data()[i]);
                }
            }
        }
    }
}

}  // namespace
}  // namespace weft::test
