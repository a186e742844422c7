#include "viewer/draw_quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "viewer/draw_effort.h"

namespace weft::viewer {
namespace {

/// A machine on which drawing costs what `costs` say, and now and then much more.
struct Machine {
    std::vector<double> costs;  ///< [level], ms
    double time = 0.0;
    int changes = 0;

    void run(DrawQuality& quality, double seconds) {
        const double end = time + seconds;
        int n = 0;
        while (time < end) {
            const std::size_t level = quality.level();
            const double noise = 1.0 + 0.1 * std::sin(1.7 * ++n);
            const double hiccup = n % 23 == 0 ? 40.0 : 0.0;
            quality.add(time, costs[level] * noise + hiccup);
            if (quality.level() != level) ++changes;
            time += 1.0 / 30.0;
        }
    }
};

TEST(DrawQuality, AFastMachineDrawsItsBest) {
    DrawQuality quality(4);
    Machine machine{{6.0, 5.0, 4.0, 3.0}};
    machine.run(quality, 60.0);
    EXPECT_EQ(quality.level(), 0U);
    EXPECT_EQ(machine.changes, 0);
}

TEST(DrawQuality, ASlowMachineReachesALevelThatFitsWithinASecond) {
    DrawQuality quality(4);
    Machine machine{{60.0, 45.0, 30.0, 15.0}};
    machine.run(quality, 1.0);
    EXPECT_EQ(quality.level(), 3U);
}

TEST(DrawQuality, TheCheapestLevelIsKeptHoweverSlowItIs) {
    DrawQuality quality(3);
    Machine machine{{600.0, 500.0, 400.0}};
    machine.run(quality, 20.0);
    EXPECT_EQ(quality.level(), 2U);
    EXPECT_EQ(machine.changes, 2);
}

TEST(DrawQuality, DoesNotFlickerBetweenALevelThatFitsAndOneThatJustDoesNot) {
    DrawQuality quality(4);
    Machine machine{{26.0, 15.5, 11.0, 8.0}};
    machine.run(quality, 600.0);
    EXPECT_EQ(quality.level(), 2U);
    EXPECT_EQ(machine.changes, 2);
}

TEST(DrawQuality, TriesThatFailBecomeRare) {
    // The better level is cheap only while it is not drawn: no ratio of costs can foretell that.
    DrawQuality quality(2);
    double time = 0.0;
    int rises = 0;
    for (int n = 0; n < 30 * 600; ++n, time += 1.0 / 30.0) {
        const std::size_t level = quality.level();
        const double since = std::fmod(time, 4.0);
        quality.add(time, level == 0 ? 30.0 : (since < 2.0 ? 20.0 : 3.0));
        if (quality.level() < level) ++rises;
    }
    EXPECT_LE(rises, 16);
}

TEST(DrawQuality, BetterLevelsComeBackOnceThereIsTime) {
    DrawQuality quality(4);
    Machine machine{{60.0, 45.0, 30.0, 15.0}};
    machine.run(quality, 10.0);
    machine.costs = {8.0, 6.0, 4.0, 2.0};
    machine.run(quality, 15.0);
    EXPECT_EQ(quality.level(), 0U);
    EXPECT_EQ(machine.changes, 6);
}

TEST(DrawQuality, LooksCloselyOnlyWhenPressed) {
    DrawQuality quality(2, 0, 20.0);
    EXPECT_TRUE(quality.pressed());
    quality.add(0.0, 10.0);
    EXPECT_FALSE(quality.pressed());
    quality.add(0.1, 18.0);
    EXPECT_TRUE(quality.pressed());
}

TEST(DrawQuality, BeginsWhereItIsTold) {
    DrawQuality quality(4, 2);
    EXPECT_EQ(quality.level(), 2U);
    Machine machine{{6.0, 5.0, 4.0, 3.0}};
    machine.run(quality, 10.0);
    EXPECT_EQ(quality.level(), 0U);
}

TEST(DrawEffort, EveryLevelIsCheaperThanTheOneBefore) {
    for (const bool fine : {false, true})
        for (const std::vector<int>& samples :
             {std::vector<int>{4, 2, 1}, std::vector<int>{4, 1}, std::vector<int>{1}}) {
            const auto efforts = draw_efforts(samples, fine);
            ASSERT_GT(efforts.size(), samples.size());
            EXPECT_EQ(efforts.front().samples, samples.front());
            EXPECT_EQ(efforts.front().options, DrawOptions{});
            EXPECT_EQ(efforts.back().samples, 1);
            EXPECT_FALSE(efforts.back().options.shadow);
            EXPECT_EQ(efforts.back().options.cloth_step, fine ? 2U : 1U);
            for (std::size_t n = 1; n < efforts.size(); ++n) {
                EXPECT_NE(describe(efforts[n]), describe(efforts[n - 1]));
                EXPECT_LE(efforts[n].samples, efforts[n - 1].samples);
                EXPECT_LE(efforts[n].options.shadow, efforts[n - 1].options.shadow);
                EXPECT_GE(efforts[n].options.cloth_step, efforts[n - 1].options.cloth_step);
            }
        }
}

TEST(DrawEffort, DriversOnTheProcessorBeginWithOneSampleAndQuickLight) {
    const auto efforts = draw_efforts(std::vector<int>{4, 1}, true);
    EXPECT_EQ(first_level(efforts, "NVIDIA GeForce RTX 3060/PCIe/SSE2"), 0U);
    const DrawEffort& first = efforts[first_level(efforts, "llvmpipe (LLVM 15.0.6, 256 bits)")];
    EXPECT_EQ(first.samples, 1);
    EXPECT_EQ(first.options.effort, Effort::quick);
    EXPECT_TRUE(first.options.shadow);
    EXPECT_EQ(first.options.cloth_step, 1U);
}

}  // namespace
}  // namespace weft::viewer
