#include "viewer/frame_times.h"

#include <gtest/gtest.h>

namespace weft::viewer {
namespace {

TEST(Durations, GiveMedianAndLargest) {
    Durations durations;
    EXPECT_EQ(durations.median(), 0.0);
    EXPECT_EQ(durations.latest(), 0.0);
    for (const double seconds : {0.02, 0.5, 0.01, 0.03, 0.04}) durations.add(seconds);
    EXPECT_EQ(durations.median(), 0.03);
    EXPECT_EQ(durations.largest(), 0.5);
    EXPECT_EQ(durations.latest(), 0.04);
}

TEST(Durations, ForgetWhatIsLongPastButNotTheLargest) {
    Durations durations;
    durations.add(9.0);
    for (int n = 0; n < 10'000; ++n) durations.add(0.01);
    for (int n = 0; n < 5'000; ++n) durations.add(0.02);
    EXPECT_EQ(durations.count(), 15'001U);
    EXPECT_EQ(durations.median(), 0.02);
    EXPECT_EQ(durations.latest(), 0.02);
    EXPECT_EQ(durations.largest(), 9.0);
}

}  // namespace
}  // namespace weft::viewer
