#include "viewer/flight_pace.h"

#include <gtest/gtest.h>

namespace weft::viewer {
namespace {

using namespace std::chrono_literals;

double seconds(FlightPace::Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

class Pace : public testing::Test {
protected:
    Pace() { pace_.set(1.0, 1.0 / 30.0); }

    FlightPace pace_;
    const FlightPace::Clock::time_point start_ = FlightPace::Clock::time_point{} + 1000s;
};

TEST_F(Pace, KeepsSimulatedTimeInStepWithTheClock) {
    pace_.begin(start_);
    EXPECT_EQ(pace_.due(), start_);
    for (int n = 0; n < 90; ++n) pace_.frame_done(pace_.due() + 4ms);
    EXPECT_NEAR(seconds(pace_.due() - start_), 3.0, 1e-6);
    EXPECT_NEAR(pace_.reached_speed(), 1.0, 1e-6);
}

TEST_F(Pace, SpeedStretchesTheTimeBetweenFrames) {
    for (const double speed : {0.01, 0.5, 4.0, 100.0}) {
        pace_.set(speed, 1.0 / 30.0);
        pace_.begin(start_);
        pace_.frame_done(start_);
        EXPECT_NEAR(seconds(pace_.due() - start_), 1.0 / 30.0 / speed, 1e-8);
    }
}

TEST_F(Pace, ASlowMachineRunsWithoutARestAndSaysHowFast) {
    pace_.begin(start_);
    auto now = start_;
    for (int n = 0; n < 20; ++n) {
        EXPECT_LE(pace_.due(), now);
        now += 200ms;
        pace_.frame_done(now);
    }
    EXPECT_NEAR(pace_.reached_speed(), (1.0 / 30.0) / 0.2, 1e-9);
}

TEST_F(Pace, CatchesUpWithOneFrameAtMost) {
    pace_.begin(start_);
    auto now = start_ + 10s;  // one frame that took long
    pace_.frame_done(now);
    int at_once = 0;
    for (; pace_.due() <= now; ++at_once) pace_.frame_done(now);
    EXPECT_EQ(at_once, 2);  // the one that is due and the one owed
}

TEST_F(Pace, AFrameLongerThanTheSecondItLooksBackStillCounts) {
    pace_.begin(start_);
    for (int n = 1; n <= 4; ++n) pace_.frame_done(start_ + n * 5s);
    EXPECT_NEAR(pace_.reached_speed(), (1.0 / 30.0) / 5.0, 1e-9);
}

TEST_F(Pace, NoSpeedAtRestOrBeforeTheFirstFrame) {
    EXPECT_EQ(pace_.reached_speed(), 0.0);
    pace_.begin(start_);
    EXPECT_EQ(pace_.reached_speed(), 0.0);
    pace_.frame_done(start_ + 1ms);
    EXPECT_EQ(pace_.reached_speed(), 1.0);  // not the 33 that one early frame would make of it
    pace_.rest();
    EXPECT_EQ(pace_.reached_speed(), 0.0);
}

TEST_F(Pace, AnotherSpeedCountsFromTheLastFrame) {
    pace_.set(0.001, 1.0 / 30.0);
    pace_.begin(start_);
    pace_.frame_done(start_);
    EXPECT_GT(pace_.due(), start_ + 30s);
    pace_.set(2.0, 1.0 / 30.0);
    EXPECT_NEAR(seconds(pace_.due() - start_), 1.0 / 60.0, 1e-8);
}

}  // namespace
}  // namespace weft::viewer
