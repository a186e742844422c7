// Energies and rates of work against their definitions, with numbers.
#include <gtest/gtest.h>

#include <limits>

#include "forces/energy.h"
#include "support/cloth_forces.h"

namespace weft::test {
namespace {

Energy energy_of(const ClothModel& cloth, const SceneDescription& scene,
                 const ParticleState<double>& state) {
    return energy<double>(cloth, scene.forces, state.x.view(), state.v.view());
}

TEST(Energy, OfASheetAtRestIsItsHeightAlone) {
    SceneDescription scene = bare_sheet(7, 5, 1.5, 1.0);
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.cloth.grid.origin = {3.0, 2.0, 1.0};
    const ClothModel cloth = build_cloth(scene);
    const Energy e = energy_of(cloth, scene, rest_state<double>(cloth));
    EXPECT_EQ(e.kinetic, 0.0);
    EXPECT_NEAR(e.springs(), 0.0, 1e-28);
    EXPECT_NEAR(e.gravity, 0.2 * 1.5 * 1.0 * 9.81 * 1.5, 1e-13);  // m g h, centre at 1.5 m
    EXPECT_NEAR(e.total(), e.gravity, 1e-13);
}

TEST(Energy, OfUniformMotionIsHalfMassTimesSpeedSquared) {
    const SceneDescription scene = bare_sheet(7, 5, 1.5, 1.0);
    const ClothModel cloth = build_cloth(scene);
    ParticleState<double> state = rest_state<double>(cloth);
    for (std::size_t p = 0; p < cloth.particle_count; ++p)
        state.v.set(cloth.slot(p), {1.0, -2.0, 2.0});
    EXPECT_NEAR(energy_of(cloth, scene, state).kinetic, 0.5 * 0.3 * 9.0, 1e-14);
}

// Stretched by a tenth along x: every horizontal spring by a tenth of its length, vertical none.
TEST(Energy, OfAStretchedSheetIsStoredByKind) {
    const SceneDescription scene = bare_sheet(5, 4, 4.0, 3.0);  // cells of 1 m
    const ClothModel cloth = build_cloth(scene);
    ParticleState<double> state = rest_state<double>(cloth);
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        const Vec3d x = state.x[cloth.slot(p)];
        state.x.set(cloth.slot(p), {1.1 * x.x, x.y, x.z});
    }
    const Energy e = energy_of(cloth, scene, state);
    EXPECT_NEAR(e.structural, 4 * 4 * 0.5 * 100.0 * 0.01, 1e-12);
    EXPECT_NEAR(e.bend, 3 * 4 * 0.5 * 5.0 * 0.04, 1e-12);
    const double stretch = std::hypot(1.1, 1.0) - std::sqrt(2.0);
    EXPECT_NEAR(e.shear, 2 * 4 * 3 * 0.5 * 40.0 * stretch * stretch, 1e-12);
}

// The force of gravity, M g, is the gradient of its energy.
TEST(Energy, OfGravityFallsByWeightTimesHeight) {
    SceneDescription scene = bare_sheet(4, 4);
    scene.forces.gravity = {1.0, -9.81, 3.0};
    const ClothModel cloth = build_cloth(scene);
    ParticleState<double> state = disturbed_state<double>(cloth, 0.2);
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        const double before = energy_of(cloth, scene, state).gravity;
        const Vec3d way{0.3, -0.2, 0.7};
        state.x.set(cloth.slot(p), state.x[cloth.slot(p)] + way);
        EXPECT_NEAR(energy_of(cloth, scene, state).gravity - before,
                    -cloth.masses[p] * dot(scene.forces.gravity, way), 1e-14);
    }
}

TEST(DragPower, IsTheCoefficientTimesTheSumOfSquaredSpeeds) {
    SceneDescription scene = bare_sheet(3, 2);
    scene.forces.damping = 0.4;
    const ClothModel cloth = build_cloth(scene);
    ParticleState<double> state = rest_state<double>(cloth);
    state.v.set(cloth.slot(2), {1.0, 2.0, 2.0});
    state.v.set(cloth.slot(5), {0.0, 0.0, -4.0});
    EXPECT_NEAR(drag_power<double>(cloth, scene.forces, state.v.view()), -0.4 * 25.0, 1e-14);
}

TEST(LargestStrain, NamesTheSpringAndItsParticles) {
    const ClothModel cloth = build_cloth(bare_sheet(4, 3, 3.0, 2.0));
    ParticleState<double> state = rest_state<double>(cloth);
    EXPECT_NEAR(largest_strain<double>(cloth, state.x.view()).strain, 0.0, 1e-15);
    state.x.set(cloth.slot(0), {-1.0, 1.0, 0.0});  // from (0, 0): shear to 5 becomes 2 sqrt(2)
    const SpringStrain s = largest_strain<double>(cloth, state.x.view());
    // Structural to (1, 0): sqrt(5) - 1 = 1.236; shear: 1; bend to (2, 0): sqrt(10)/2 - 1.
    EXPECT_NEAR(s.strain, std::sqrt(5.0) - 1.0, 1e-14);
    EXPECT_EQ(s.kind, "structural");
    EXPECT_EQ(s.p, 0u);
    EXPECT_EQ(s.q, 1u);
    state.x.set(cloth.slot(0), {1.0, 0.0, 0.0});  // upon particle 1: wholly compressed
    EXPECT_NEAR(largest_strain<double>(cloth, state.x.view()).strain, -1.0, 1e-14);
}

TEST(LargestStrain, FindsWhatIsNotFinite) {
    const ClothModel cloth = build_cloth(bare_sheet(4, 3));
    ParticleState<double> state = rest_state<double>(cloth);
    state.x.set(cloth.slot(7), {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0});
    const SpringStrain s = largest_strain<double>(cloth, state.x.view());
    EXPECT_TRUE(std::isnan(s.strain));
    EXPECT_TRUE(s.p == 7 || s.q == 7);
}

}  // namespace
}  // namespace weft::test
