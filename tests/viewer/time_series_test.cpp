#include "viewer/time_series.h"

#include <gtest/gtest.h>

namespace weft::viewer {
namespace {

TEST(TimeSeries, KeepsTheLatestSamples) {
    TimeSeries series(3);
    for (int n = 0; n < 5; ++n) series.add(0.5 * n, n * n);
    ASSERT_EQ(series.times().size(), 3U);
    EXPECT_EQ(series.times()[0], 1.0F);
    EXPECT_EQ(series.values()[2], 16.0F);
}

TEST(TimeSeries, BeginsAnewWhenTimeGoesBack) {
    TimeSeries series(10);
    series.add(1.0, 3.0);
    series.add(2.0, 4.0);
    series.add(0.0, 5.0);
    ASSERT_EQ(series.values().size(), 1U);
    EXPECT_EQ(series.values()[0], 5.0F);
}

}  // namespace
}  // namespace weft::viewer
