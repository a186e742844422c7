// What obstacles do to a step, against the formulas of docs/contact.md.
#include "contact/obstacle_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact_scenes.h"
#include "math/parallel.h"
#include "support/cloth_forces.h"

namespace weft::test {
namespace {

constexpr double h = 0.01;  // [s]

// A step of the second of three particles; the first is pinned.
struct Stepped {
    bool touched;
    Vec3d x, v;
};

Stepped step(const std::vector<ObstacleDescription>& obstacles, Vec3d start, Vec3d end, Vec3d v) {
    ClothModel cloth = straight_chain(3, 1.0, 1.0, 1.0);
    pin_at_rest(cloth, 0);
    ObstacleContact<double> contact(cloth);
    contact.set(obstacles);
    Vec3Array<double> x(3), velocities(3);
    x.set(2, {1e3, 1e3, 1e3});
    x.set(1, start);
    contact.begin_step(x);
    x.set(0, end);
    x.set(1, end);
    velocities.set(0, v);
    velocities.set(1, v);
    const bool touched = contact.apply(h, {}, x.view(), velocities.view());
    if (is_finite(end)) {
        EXPECT_EQ(x[0], end);  // pinned
        EXPECT_EQ(velocities[0], v);
    }
    EXPECT_EQ(x[2], (Vec3d{1e3, 1e3, 1e3}));
    return {touched, x[1], velocities[1]};
}

void expect_near(Vec3d value, Vec3d expected) {
    EXPECT_LT(length(value - expected), 1e-12)
        << value.x << " " << value.y << " " << value.z << " for " << expected.x << " " << expected.y
        << " " << expected.z;
}

TEST(ObstacleContact, LeavesWhatIsOutside) {
    const Stepped left = step({floor_with(0.5, 0.1)}, {0, 0.3, 0}, {0, 0.2, 0}, {0, -10, 0});
    EXPECT_FALSE(left.touched);
    EXPECT_EQ(left.x, (Vec3d{0, 0.2, 0}));
    EXPECT_EQ(left.v, (Vec3d{0, -10, 0}));
}

// From 0.15 to 0.05 above the floor of gap 0.1: half the step it touches. mu |dv_n| = 5 of the 8
// m/s along it go, and 5/8 of the way of that half.
TEST(ObstacleContact, TakesInwardVelocityAndCoulombsShareAlongThePlane) {
    const Stepped slid = step({floor_with(0.5, 0.1)}, {0, 0.15, 0}, {0.08, 0.05, 0}, {8, -10, 0});
    EXPECT_TRUE(slid.touched);
    expect_near(slid.v, {3, 0, 0});
    expect_near(slid.x, {0.08 - 0.625 * 0.04, 0.1, 0});
    const Stepped stuck = step({floor_with(1.0, 0.1)}, {0, 0.15, 0}, {0.08, 0.05, 0}, {8, -10, 0});
    expect_near(stuck.v, {});
    expect_near(stuck.x, {0.04, 0.1, 0});
    const Stepped smooth = step({floor_with(0.0, 0.1)}, {0, 0.15, 0}, {0.08, 0.05, 0}, {8, -10, 0});
    expect_near(smooth.v, {8, 0, 0});
    expect_near(smooth.x, {0.08, 0.1, 0});
}

TEST(ObstacleContact, LeavesTheVelocityOfWhatIsOnItsWayOut) {
    const Stepped out = step({floor_with(0.5)}, {0, 0, 0}, {0.01, -0.001, 0}, {1, 2, 0});
    EXPECT_TRUE(out.touched);
    expect_near(out.v, {1, 2, 0});
    expect_near(out.x, {0.01, 0.0, 0});
}

TEST(ObstacleContact, TakesPlanesOfAnyNormal) {
    for (const double size : {1e-200, 1.0, 1e200}) {
        const ObstacleDescription slope{PlaneObstacle{{1, 1, 0}, {size, size, 0}}, 0.0, 0.0};
        const Stepped out = step({slope}, {1.5, 1.5, 0}, {0.5, 0.5, 0}, {-1, -2, 0});
        expect_near(out.x, {1, 1, 0});
        expect_near(out.v, {0.5, -0.5, 0});
    }
}

TEST(ObstacleContact, PutsOnTheNearestOfASphere) {
    const ObstacleDescription ball{SphereObstacle{{0, 0, 0}, 0.9}, 0.0, 0.1};
    const Stepped out = step({ball}, {0, 1.0, 0}, {0.3, 0.9, 0}, {3, -1, 0});
    EXPECT_NEAR(length(out.x), 1.0, 1e-12);
    EXPECT_NEAR(dot(out.x, out.v), 0.0, 1e-12);
    expect_near(cross(out.x, {0.3, 0.9, 0}), {});
}

// However fast, and though it would end behind it or beyond its centre.
TEST(ObstacleContact, LetsNothingThroughASphere) {
    const ObstacleDescription ball{SphereObstacle{{0, 0, 0}, 0.1}, 0.0, 0.0};
    for (const double end : {0.05, -0.05, -0.5, -100.0}) {
        const Stepped hit = step({ball}, {0.02, 1.0, 0}, {0.02, end, 0}, {0, (end - 1.0) / h, 0});
        EXPECT_TRUE(hit.touched) << end;
        EXPECT_GE(length(hit.x), 0.1 - 1e-12) << end;
        const Vec3d normal = Vec3d{0.02, std::sqrt(0.01 - 0.0004), 0} / 0.1;
        EXPECT_GE(dot(hit.x, normal), end < 0.0 ? 0.1 - 1e-12 : 0.0) << end;
        EXPECT_GE(dot(hit.v, end > 0.0 ? hit.x : normal), -1e-9) << end;
    }
    const Stepped past = step({ball}, {0.2, 1.0, 0}, {0.2, -1.0, 0}, {0, -200, 0});
    EXPECT_FALSE(past.touched);
}

// An obstacle that was moved into the cloth pushes it out at 10 m/s.
TEST(ObstacleContact, MovesOutGentlyWhatWasInsideBefore) {
    const Stepped deep = step({floor_with(0.5)}, {0, -0.3, 0}, {0, -0.3, 0}, {});
    expect_near(deep.x, {0, -0.2, 0});
    expect_near(deep.v, {});
    const Stepped shallow = step({floor_with(0.5)}, {0, -0.05, 0}, {0, -0.06, 0}, {0, -1, 0});
    expect_near(shallow.x, {});
    expect_near(shallow.v, {});
}

// A ball that lies on the ground: in the wedge between, both hold.
TEST(ObstacleContact, HoldsBetweenTwoObstacles) {
    const ObstacleDescription ball{SphereObstacle{{0, 0.2, 0}, 0.2}, 0.3, 0.0};
    const Stepped wedged =
        step({ball, floor_with(0.3)}, {0.2, 0.05, 0}, {0.12, -0.02, 0}, {-8, -7, 0});
    EXPECT_GE(wedged.x.y, -1e-12);
    EXPECT_GE(length(wedged.x - Vec3d{0, 0.2, 0}), 0.2 - 1e-3);
    EXPECT_LT(length(wedged.v), length(Vec3d{-8, -7, 0}));
}

TEST(ObstacleContact, LeavesWhatIsNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Stepped bad =
        step({floor_with(0.5), {SphereObstacle{}, 0.1, 0.0}}, {}, {nan, nan, nan}, {});
    EXPECT_FALSE(bad.touched);
}

TEST(ObstacleContact, GivesTheSameBitsOnAnyNumberOfThreads) {
    const SceneDescription scene = level_sheet(200, 0.3);
    const ClothModel cloth = build_cloth(scene);
    const auto run = [&](int threads) {
        ThreadTeam team(threads);
        ObstacleContact<float> contact(cloth);
        contact.set(std::vector<ObstacleDescription>{{SphereObstacle{{0, 0.2, 0}, 0.12}, 0.4, 0.0},
                                                     floor_with(0.2, 0.29)});
        ParticleState<float> state = disturbed_state<float>(cloth, 0.01);
        team.run([&] {
            contact.begin_step(state.x);
            disturb(cloth, state.x, 0.02, 9);
            EXPECT_TRUE(contact.apply(h, {}, state.x.view(), state.v.view()));
        });
        return state;
    };
    const ParticleState<float> one = run(1), many = run(7);
    EXPECT_EQ(different_bits(one.x, many.x), 0u);
    EXPECT_EQ(different_bits(one.v, many.v), 0u);
}

}  // namespace
}  // namespace weft::test
