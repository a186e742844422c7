// The patch of cloth that a hand takes hold of.
#include "viewer/grip_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace weft::viewer {
namespace {

// 5 x 5 particles, a metre apart: particle 12 is in the middle at (2, 2, 0).
std::vector<Vec3d> square() {
    std::vector<Vec3d> positions;
    for (int j = 0; j < 5; ++j) {
        for (int i = 0; i < 5; ++i) positions.push_back({1.0 * i, 1.0 * j, 0.0});
    }
    return positions;
}

TEST(GripPatch, HoldsTheParticlesWithinItsRadius) {
    const auto grips = GripPatch(square(), 12, {2, 2, 0}, 1.2, 1.0).grips({2, 2, 0});
    std::vector<std::size_t> particles;
    for (const Grip& grip : grips) particles.push_back(grip.particle);
    EXPECT_EQ(particles, (std::vector<std::size_t>{7, 11, 12, 13, 17}));
}

TEST(GripPatch, IsSofterOutward) {
    const auto grips = GripPatch(square(), 12, {2, 2, 0}, 2.5, 1.0).grips({2, 2, 0});
    const auto stiffness = [&](std::size_t particle) {
        for (const Grip& grip : grips) {
            if (grip.particle == particle) return grip.stiffness;
        }
        return 0.0;
    };
    EXPECT_GT(stiffness(12), stiffness(13));
    EXPECT_GT(stiffness(13), stiffness(18));
    EXPECT_GT(stiffness(18), stiffness(14));
    EXPECT_GT(stiffness(14), 0.0);
    EXPECT_EQ(stiffness(0), 0.0);
    EXPECT_NEAR(stiffness(11), stiffness(13), 1e-12 * stiffness(13));
}

// 30 weights at a stretch of the radius, whatever the resolution.
TEST(GripPatch, PullsWithTensOfTheClothsWeightTogether) {
    for (const double radius : {0.5, 1.2, 3.0}) {
        double stiffness = 0.0, damping = 0.0;
        for (const Grip& grip : GripPatch(square(), 12, {2, 2, 0}, radius, 0.4).grips({})) {
            stiffness += grip.stiffness;
            damping += grip.damping;
        }
        EXPECT_NEAR(stiffness * radius, 30 * 0.4 * 9.81, 1e-9) << radius;
        EXPECT_NEAR(damping, 2.0 * std::sqrt(stiffness * 0.4), 1e-9) << radius;
    }
}

TEST(GripPatch, KeepsEveryParticlesPlaceInThePatch) {
    const GripPatch patch(square(), 12, {2.1, 1.9, 0.0}, 1.2, 1.0);
    const auto positions = square();
    for (const Grip& grip : patch.grips({2.1, 1.9, 0.0})) {
        EXPECT_EQ(grip.point, positions[grip.particle]);
    }
    for (const Grip& grip : patch.grips({3.1, 1.9, -2.0})) {
        EXPECT_LT(length(grip.point - positions[grip.particle] - Vec3d{1.0, 0.0, -2.0}), 1e-15);
    }
}

TEST(GripPatch, HoldsItsParticleHoweverSmallTheRadius) {
    const auto grips = GripPatch(square(), 24, {4, 4, 0}, 1e-6, 1.0).grips({4, 4, 0});
    ASSERT_EQ(grips.size(), 1U);
    EXPECT_EQ(grips[0].particle, 24U);
}

TEST(GripPatch, LeavesOutParticlesThatAreNowhere) {
    auto positions = square();
    positions[13].y = std::numeric_limits<double>::quiet_NaN();
    for (const Grip& grip : GripPatch(positions, 12, {2, 2, 0}, 1.2, 1.0).grips({2, 2, 0})) {
        EXPECT_NE(grip.particle, 13U);
        EXPECT_TRUE(std::isfinite(grip.stiffness));
    }
}

}  // namespace
}  // namespace weft::viewer
