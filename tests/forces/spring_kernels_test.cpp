// The grid's readable spring kernel against any split into bands, to the bit; and against the
// mesh's kernel and a plain loop, to rounding. Sizes cover rows of whole cache lines and rows with
// padding.
#include <gtest/gtest.h>

#include "support/cloth_forces.h"
#include "support/naive_cloth.h"

namespace weft::test {
namespace {

struct Size {
    int columns, rows;
};

const std::vector<Size> sizes{{2, 2},   {2, 3},   {3, 2},   {3, 3},   {4, 5},   {5, 9},   {7, 7},
                              {8, 4},   {9, 3},   {15, 6},  {16, 5},  {17, 4},  {31, 3},  {33, 7},
                              {65, 5},  {255, 3}, {256, 3}, {257, 4}, {258, 3}, {259, 2}, {300, 5},
                              {512, 3}, {513, 3}, {514, 4}, {515, 2}, {2, 300}, {3, 270}};

SceneDescription scene_of(Size size, StiffnessPer per, BendLayout layout, bool damped) {
    SceneDescription scene =
        bare_sheet(size.columns, size.rows, 0.1 * (size.columns - 1), 0.13 * (size.rows - 1));
    scene.material.stiffness_per = per;
    scene.material.bend_layout = layout;
    if (damped) add_dashpots(scene, 0.02);
    return scene;
}

template <typename Visit>
void for_each_scene(const Visit& visit) {
    for (const Size size : sizes) {
        for (const StiffnessPer per : {StiffnessPer::spring, StiffnessPer::width}) {
            for (const BendLayout layout : {BendLayout::interior, BendLayout::border}) {
                for (const bool damped : {false, true}) {
                    SCOPED_TRACE(std::to_string(size.columns) + " x " + std::to_string(size.rows));
                    visit(scene_of(size, per, layout, damped));
                }
            }
        }
    }
}

// Bands of 1, 2, 3, ... rows in turn, last band first.
template <typename Real>
Vec3Array<Real> banded_forces(const ClothModel& cloth, const ParticleState<Real>& state) {
    const GridSprings<Real> springs(cloth);
    Vec3Array<Real> f(cloth.layout.slot_count());
    std::vector<std::size_t> cuts{0};
    for (std::size_t rows = 1; cuts.back() + rows < cloth.shape.rows; ++rows) {
        cuts.push_back(cuts.back() + rows);
    }
    cuts.push_back(cloth.shape.rows);
    for (std::size_t n = cuts.size() - 1; n > 0; --n) {
        springs.add_forces(state.x.view(), state.v.view(), f.view(), cuts[n - 1], cuts[n]);
    }
    return f;
}

template <typename Real>
class GridSpringKernel : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(GridSpringKernel, Precisions);

TYPED_TEST(GridSpringKernel, GivesTheSameBitsInAnyBands) {
    for_each_scene([](const SceneDescription& scene) {
        const ClothModel cloth = build_cloth(scene);
        const auto state = disturbed_state<TypeParam>(cloth, 0.1);
        EXPECT_EQ(different_bits(spring_forces(cloth, state), banded_forces(cloth, state)), 0u);
    });
}

TYPED_TEST(GridSpringKernel, AgreesWithThePlainLoopAndTheMeshKernel) {
    for_each_scene([](const SceneDescription& scene) {
        const ClothModel cloth = build_cloth(scene);
        const auto state = disturbed_state<TypeParam>(cloth, 0.1);
        const std::vector<Vec3d> grid = as_vectors(cloth, spring_forces(cloth, state));
        std::vector<Vec3d> plain(cloth.particle_count);
        NaiveCloth(scene).add_springs(as_vectors(cloth, state.x), as_vectors(cloth, state.v),
                                      plain);
        Vec3Array<TypeParam> mesh(cloth.layout.slot_count());
        MeshSprings<TypeParam>(cloth).add_forces(state.x.view(), state.v.view(), mesh.view(), 0,
                                                 cloth.layout.slot_count());
        // float places of up to 51 m leave lengths of 0.1 m four to five digits.
        const double extent = std::hypot(scene.cloth.grid.size[0], scene.cloth.grid.size[1]);
        const double tolerance = (sizeof(TypeParam) == 4 ? 1e-6 : 1e-15) * (1 + extent / 0.1);
        ASSERT_GT(largest(plain), 0.5);
        EXPECT_LT(largest_difference(grid, plain), tolerance * largest(plain) * 10);
        EXPECT_LT(largest_difference(as_vectors(cloth, mesh), plain),
                  tolerance * largest(plain) * 10);
    });
}

// Forces are added to what is there.
TYPED_TEST(GridSpringKernel, AddsToTheForcesItIsGiven) {
    const ClothModel cloth = build_cloth(bare_sheet(5, 5));
    const auto state = rest_state<TypeParam>(cloth);
    Vec3Array<TypeParam> f(cloth.layout.slot_count());
    for (std::size_t s = 0; s < f.size(); ++s) f.set(s, {1, 2, 3});
    GridSprings<TypeParam>(cloth).add_forces(state.x.view(), state.v.view(), f.view(), 1, 3);
    for (std::size_t s = 0; s < f.size(); ++s) {
        EXPECT_LT(length(f[s] - Vec3<TypeParam>{1, 2, 3}), 1e-4) << s;
    }
}

// Any split of a mesh's particles gives the same bits.
TYPED_TEST(GridSpringKernel, OfAMeshGivesTheSameBitsInAnyParts) {
    SceneDescription scene = bare_sheet(13, 9);
    add_dashpots(scene, 0.02);
    make_mesh_of_grid(scene);
    const ClothModel cloth = build_cloth(scene);
    const auto state = disturbed_state<TypeParam>(cloth, 0.1);
    const MeshSprings<TypeParam> springs(cloth);
    Vec3Array<TypeParam> parts(cloth.layout.slot_count());
    for (std::size_t s = parts.size(); s > 0; --s) {
        springs.add_forces(state.x.view(), state.v.view(), parts.view(), s - 1, s);
    }
    EXPECT_EQ(different_bits(spring_forces(cloth, state), parts), 0u);
}

// A particle's sum has its order from the springs, not from where its neighbours stand.
TYPED_TEST(GridSpringKernel, OfAMeshGivesTheSameBitsInAnyLayout) {
    SceneDescription scene = bare_sheet(13, 9);
    add_dashpots(scene, 0.02);
    make_mesh_of_grid(scene);
    ClothModel cloth = build_cloth(scene);
    const auto forces = [&] {
        return as_vectors(cloth, spring_forces(cloth, disturbed_state<TypeParam>(cloth, 0.1)));
    };
    const std::vector<Vec3d> in_order = forces();
    shuffle_layout(cloth);
    EXPECT_EQ(forces(), in_order);
}

}  // namespace
}  // namespace weft::test
