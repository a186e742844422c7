// The force of the air: Hoerner's plate at every angle, and the grid's kernel against the mesh's
// and a plain loop.
#include <gtest/gtest.h>

#include <numbers>

#include "support/cloth_forces.h"
#include "support/naive_cloth.h"

namespace weft::test {
namespace {

constexpr double rho = 1.2, speed = 7.0, friction = 0.01;  // [kg/m3], [m/s], [1]

WindDescription air_of(double skin_friction = friction) {
    WindDescription wind;
    wind.air_density = rho;
    wind.skin_friction = skin_friction;
    return wind;
}

// Sum over a flat sheet of 1.5 x 0.8 m held in the xy plane.
Vec3d force_on_plate(Vec3d wind, double skin_friction = friction) {
    const ClothModel cloth = build_cloth(bare_sheet(7, 5, 1.5, 0.8));
    const auto state = rest_state<double>(cloth);
    return sum_of(grid_air_forces(air_of(skin_friction), cloth, wind, state));
}

constexpr double area = 1.5 * 0.8;  // [m2]

// Normal force 1/2 rho V^2 A C_N, C_N = 1 / (0.222 + 0.283 / sin a); friction on both sides.
TEST(PlateForce, IsHoernersAtEveryAngle) {
    for (const double degrees : {1.0, 5.0, 15.0, 30.0, 45.0, 60.0, 80.0, 90.0}) {
        for (const double side : {1.0, -1.0}) {
            const double a = degrees * std::numbers::pi / 180.0;
            const Vec3d wind =
                speed * Vec3d{0.6 * std::cos(a), 0.8 * std::cos(a), side * std::sin(a)};
            const Vec3d f = force_on_plate(wind);
            const double coefficient = 1.0 / (0.222 + 0.283 / std::sin(a));
            EXPECT_NEAR(f.z, side * 0.5 * rho * speed * speed * area * coefficient, 1e-12);
            const double along = 0.5 * rho * 2 * area * friction * std::pow(speed * std::cos(a), 2);
            EXPECT_NEAR(f.x, 0.6 * along, 1e-13);
            EXPECT_NEAR(f.y, 0.8 * along, 1e-13);
        }
    }
}

TEST(PlateForce, HasCoefficient198FaceOn) {
    const double f = force_on_plate({0.0, 0.0, speed}).z;
    EXPECT_NEAR(f / (0.5 * rho * speed * speed * area), 1.98, 0.001);
}

TEST(PlateForce, EdgeOnIsFrictionAlone) {
    const Vec3d f = force_on_plate({speed, 0.0, 0.0});
    EXPECT_NEAR(f.x, 0.5 * rho * speed * speed * 2 * area * friction, 1e-14);
    EXPECT_EQ(f.z, 0.0);
    EXPECT_EQ(length(force_on_plate({speed, 0.0, 0.0}, 0.0)), 0.0);
}

// Small angles: slope 3.5 per radian.
TEST(PlateForce, RisesBy35PerRadianAtSmallAngles) {
    const double a = 1e-4;
    const Vec3d f = force_on_plate(speed * Vec3d{std::cos(a), 0.0, std::sin(a)});
    EXPECT_NEAR(f.z / (0.5 * rho * speed * speed * area) / a, 1 / 0.283, 2e-3);
}

TEST(PlateForce, IsThatOfTheRelativeWind) {
    const ClothModel cloth = build_cloth(bare_sheet(4, 4));
    auto state = rest_state<double>(cloth);
    const Vec3d wind{3.0, -1.0, 2.0}, motion{1.0, 2.0, -4.0};
    for (std::size_t p = 0; p < cloth.particle_count; ++p) state.v.set(cloth.slot(p), motion);
    const auto moving = grid_air_forces(air_of(), cloth, wind, state);
    for (std::size_t p = 0; p < cloth.particle_count; ++p) state.v.set(cloth.slot(p), {});
    const auto still = grid_air_forces(air_of(), cloth, wind - motion, state);
    EXPECT_LT(largest_difference(moving, still), 1e-15);
}

TEST(PlateForce, IsZeroWithoutRelativeWindOrArea) {
    const ClothModel cloth = build_cloth(bare_sheet(4, 4));
    auto state = rest_state<float>(cloth);
    EXPECT_EQ(largest(grid_air_forces(air_of(), cloth, {}, state)), 0.0);
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        const Vec3f x = state.x[cloth.slot(p)];
        state.x.set(cloth.slot(p), {x.x, 0.0f, 0.0f});  // crumpled onto a line
    }
    EXPECT_EQ(largest(grid_air_forces(air_of(), cloth, {1, 2, 3}, state)), 0.0);
    EXPECT_EQ(largest(mesh_air_forces(air_of(), cloth, {1, 2, 3}, state)), 0.0);
}

// Nothing, to the square of the speed: no NaN where the formula has 0 / 0.
TEST(PlateForce, IsSmoothAtNoWind) {
    for (const double v : {1e-30, 1e-20, 1e-10}) {
        const Vec3d f = force_on_plate({0.0, 0.0, v});
        EXPECT_TRUE(is_finite(f));
        EXPECT_LE(f.z, 2.5 * v * v);
    }
}

// A third to each corner of a triangle alone.
TEST(MeshAir, GivesEachCornerAThird) {
    ClothModel cloth = straight_chain(3, 1.0, 1.0, 1.0);
    cloth.surface.triangles = {{0, 1, 2}};
    ParticleState<double> state{Vec3Array<double>(3), Vec3Array<double>(3), 0.0};
    state.x.set(1, {2.0, 0.0, 0.0});
    state.x.set(2, {0.0, 1.0, 0.0});
    const auto f = mesh_air_forces(air_of(), cloth, {0.0, 0.0, 3.0}, state);
    const double third = 0.5 * rho * 9.0 * 1.0 / (0.222 + 0.283) / 3.0;
    for (const Vec3d corner : f) EXPECT_NEAR(corner.z, third, 1e-14);
}

TEST(MeshAir, PowerIsForceTimesVelocity) {
    const ClothModel cloth = build_cloth(bare_sheet(6, 5));
    const auto state = disturbed_state<double>(cloth, 0.2);
    MeshAir<double> air(air_of(), cloth.surface, cloth.layout);
    air.compute({4.0, 1.0, 2.0}, state.x.view(), state.v.view(), 0, air.triangle_count());
    Vec3Array<double> f(cloth.layout.slot_count());
    air.add_forces(f.view(), 0, cloth.layout.slot_count());
    double power = 0.0;
    for (std::size_t s = 0; s < f.size(); ++s) power += dot(f[s], state.v[s]);
    EXPECT_NEAR(air.power(state.v.view()), power, 1e-13 * std::abs(power));
}

template <typename Real>
class GridAirKernel : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(GridAirKernel, Precisions);

template <typename Visit>
void for_each_size(const Visit& visit) {
    for (const auto& [columns, rows] : {std::pair{2, 2},
                                        {2, 5},
                                        {5, 2},
                                        {3, 3},
                                        {9, 7},
                                        {17, 4},
                                        {256, 3},
                                        {257, 3},
                                        {258, 4},
                                        {300, 3},
                                        {514, 3},
                                        {3, 200}}) {
        SceneDescription scene = bare_sheet(columns, rows, 0.1 * (columns - 1), 0.13 * (rows - 1));
        scene.wind = air_of();
        scene.wind->drag = 0.7;
        visit(scene);
    }
}

TYPED_TEST(GridAirKernel, AgreesWithThePlainLoopAndTheMeshKernel) {
    for_each_size([](const SceneDescription& scene) {
        const ClothModel cloth = build_cloth(scene);
        const auto state = disturbed_state<TypeParam>(cloth, 0.1);
        const Vec3d wind{6.0, -1.0, 3.0};
        std::vector<Vec3d> plain(cloth.particle_count);
        NaiveCloth(scene).add_air(wind, as_vectors(cloth, state.x), as_vectors(cloth, state.v),
                                  plain);
        const auto grid = grid_air_forces(*scene.wind, cloth, wind, state);
        const auto mesh = mesh_air_forces(*scene.wind, cloth, wind, state);
        const double tolerance = (sizeof(TypeParam) == 4 ? 2e-4 : 1e-12) * largest(plain);
        ASSERT_GT(largest(plain), 0.01);
        EXPECT_LT(largest_difference(grid, plain), tolerance);
        EXPECT_LT(largest_difference(mesh, plain), tolerance);
    });
}

TYPED_TEST(GridAirKernel, GivesTheSameBitsInAnyBands) {
    for_each_size([](const SceneDescription& scene) {
        const ClothModel cloth = build_cloth(scene);
        const auto state = disturbed_state<TypeParam>(cloth, 0.1);
        const Vec3<TypeParam> wind{6, -1, 3};
        const GridAir<TypeParam> air(*scene.wind, cloth.shape, cloth.layout.row_stride());
        Vec3Array<TypeParam> whole(cloth.layout.slot_count()), bands(cloth.layout.slot_count());
        air.add_forces(wind, state.x.view(), state.v.view(), whole.view(), 0, cloth.shape.rows);
        std::size_t end = cloth.shape.rows;
        for (std::size_t rows = 1; end > 0; ++rows) {
            const std::size_t begin = end - std::min(rows, end);
            air.add_forces(wind, state.x.view(), state.v.view(), bands.view(), begin, end);
            end = begin;
        }
        EXPECT_EQ(different_bits(whole, bands), 0u);
    });
}

}  // namespace
}  // namespace weft::test
