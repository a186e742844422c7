#include "viewer/strain_scale.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace weft::viewer {
namespace {

TEST(StrainScale, RoundsUpToOneTwoFive) {
    EXPECT_FLOAT_EQ(round_strain(0.0F), 0.005F);
    EXPECT_FLOAT_EQ(round_strain(0.006F), 0.01F);
    EXPECT_FLOAT_EQ(round_strain(0.02F), 0.02F);
    EXPECT_FLOAT_EQ(round_strain(0.13F), 0.2F);
    EXPECT_FLOAT_EQ(round_strain(40.0F), 1.0F);
}

TEST(StrainScale, FollowsUpAtOnceAndDownOnlyByTwoSteps) {
    StrainScale scale;
    scale.follow(0.04F);
    EXPECT_FLOAT_EQ(scale.range(), 0.05F);
    scale.follow(0.015F);
    EXPECT_FLOAT_EQ(scale.range(), 0.05F);
    scale.follow(0.009F);
    EXPECT_FLOAT_EQ(scale.range(), 0.01F);
}

/// Springs of rest length 1 from the origin to points on the x axis.
struct Comb {
    std::vector<Vec3d> positions{Vec3d{}};
    std::vector<DrawnSpring> springs;

    void add(double length) {
        positions.push_back({length, 0.0, 0.0});
        springs.push_back({0, static_cast<std::uint32_t>(positions.size() - 1), 1.0F, 0});
    }
    [[nodiscard]] float usual() const {
        Frame frame;
        frame.positions = positions;
        return usual_strain(springs, frame);
    }
};

TEST(StrainScale, OneSpringInFiftyMayBeStretchedMore) {
    Comb comb;
    for (int n = 0; n < 98; ++n) comb.add(n % 2 == 0 ? 1.03 : 0.97);
    comb.add(3.0);
    comb.add(5.0);
    EXPECT_NEAR(comb.usual(), 0.03F, 1e-6F);
}

TEST(StrainScale, TakesNothingFromSpringsThatAreNoNumbers) {
    Comb comb;
    EXPECT_EQ(comb.usual(), 0.0F);
    comb.add(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(comb.usual(), 0.0F);
    comb.add(1.25);
    EXPECT_NEAR(comb.usual(), 0.25F, 1e-6F);
}

TEST(StrainScale, IsReadInPercent) {
    EXPECT_EQ(percent_text(0.05F), "5 %");
    EXPECT_EQ(percent_text(0.005F), "0.5 %");
    EXPECT_EQ(percent_text(1.0F), "100 %");
}

}  // namespace
}  // namespace weft::viewer
