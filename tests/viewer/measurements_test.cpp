#include "viewer/measurements.h"

#include <gtest/gtest.h>

namespace weft::viewer {
namespace {

FlightView view_at(double time, double gravity) {
    FlightView view;
    LaneView lane;
    lane.frame.time = time;
    lane.energy = {.kinetic = 2.0, .gravity = gravity, .structural = 0.5};
    lane.steps_per_frame = 10;
    lane.milliseconds = 5.0;
    view.lanes.push_back(lane);
    return view;
}

TEST(Measurements, TakeEachMomentOnce) {
    Measurements measurements;
    measurements.add(view_at(0.0, 7.0));
    measurements.add(view_at(0.1, 6.0));
    measurements.add(view_at(0.1, 6.0));
    ASSERT_EQ(measurements.lanes().size(), 1U);
    EXPECT_EQ(measurements.lanes()[0].kinetic.values().size(), 2U);
}

TEST(Measurements, CountGravityFromTheStart) {
    Measurements measurements;
    measurements.add(view_at(0.0, 7.0));
    measurements.add(view_at(0.1, 6.0));
    const LaneMeasurements& lane = measurements.lanes()[0];
    EXPECT_EQ(lane.gravity.values()[0], 0.0F);
    EXPECT_EQ(lane.gravity.values()[1], -1.0F);
    EXPECT_EQ(lane.total.values()[1], 1.5F);
    EXPECT_EQ(lane.steps_per_second.values()[1], 2000.0F);
}

TEST(Measurements, BeginAnewAfterAResetAndWithOtherLanes) {
    Measurements measurements;
    measurements.add(view_at(0.0, 7.0));
    measurements.add(view_at(3.0, 6.0));
    measurements.add(view_at(0.0, 5.0));
    EXPECT_EQ(measurements.lanes()[0].gravity.values().size(), 1U);
    EXPECT_EQ(measurements.lanes()[0].first_gravity, 5.0);
    FlightView two = view_at(1.0, 4.0);
    two.lanes.push_back(two.lanes[0]);
    measurements.add(two);
    ASSERT_EQ(measurements.lanes().size(), 2U);
    EXPECT_EQ(measurements.lanes()[0].kinetic.values().size(), 1U);
}

TEST(Measurements, TakeTheStartOfASceneThatWasChangedThere) {
    Measurements measurements;
    measurements.add(view_at(0.0, 7.0));
    measurements.add(view_at(0.0, 14.0));
    EXPECT_EQ(measurements.lanes()[0].total.values().size(), 1U);
    EXPECT_EQ(measurements.lanes()[0].first_gravity, 14.0);
    EXPECT_EQ(measurements.lanes()[0].total.values()[0], 2.5F);
}

TEST(Measurements, TellWhereAFlightFallsBehind) {
    FlightView view = view_at(0.0, 1.0);
    view.playing = true;
    view.speed = 2.0;
    view.reached_speed = 1.7;
    EXPECT_TRUE(falls_behind(view));
    view.reached_speed = 1.9;
    EXPECT_FALSE(falls_behind(view));
    view.reached_speed = 0.0;  // not known yet
    EXPECT_FALSE(falls_behind(view));
}

TEST(Measurements, SayNothingOfSpeedBeforeAFrameWasMade) {
    Measurements measurements;
    FlightView view = view_at(0.0, 1.0);
    view.lanes[0].milliseconds = 0.0;
    measurements.add(view);
    EXPECT_TRUE(measurements.lanes()[0].milliseconds.values().empty());
    EXPECT_EQ(steps_per_second(view.lanes[0]), 0.0);
}

}  // namespace
}  // namespace weft::viewer
