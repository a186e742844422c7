// How timings become rows, on contestants whose times are known.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "bench/suite/suite.h"
#include "weft/error.h"

namespace weft::bench {
namespace {

// Says that it made one step in the next of the given times, and writes down that it was asked.
class Scripted final : public Contestant {
public:
    Scripted(char name, std::vector<double> seconds, std::string& turns)
        : name_(name), seconds_(std::move(seconds)), turns_(turns) {}
    Measurement measure(double /*least_seconds*/) override {
        turns_ += name_;
        if (seconds_.empty()) throw Error(ErrorKind::diverged, {}, "it blew up");
        Measurement found;
        found.steps = 1.0;
        found.seconds = seconds_.front();
        seconds_.erase(seconds_.begin());
        return found;
    }

private:
    char name_;
    std::vector<double> seconds_;
    std::string& turns_;
};

class BenchSuite : public testing::Test {
protected:
    void add(char name, const std::string& label, std::vector<double> seconds) {
        Entry entry;
        entry.label = {label, 10, 10, Precision::f64, 1};
        entry.flops_per_step = 2e4;
        entry.against_textbook = true;
        entry.make = [this, name, seconds] {
            return std::make_unique<Scripted>(name, seconds, turns_);
        };
        group_.entries.push_back(entry);
    }
    std::vector<Row> rows() {
        return time_group(group_, machine_, 0.0, [] { return false; });
    }
    Group group_;
    Machine machine_;
    std::string turns_;
};

TEST_F(BenchSuite, ContestantsAreTimedInTurn) {
    add('t', "textbook", {4e-6, 4e-6, 4e-6});
    add('a', "rk4", {1e-6, 1e-6, 1e-6});
    rows();
    EXPECT_EQ(turns_, "tatata");
}

TEST_F(BenchSuite, RowsAreMediansAndRatiosAreTakenWithinARepeat) {
    machine_.peak_double = 100.0;
    add('t', "textbook", {4e-6, 40e-6, 5e-6});  // slow together in the second repeat
    add('a', "rk4", {1e-6, 10e-6, 1e-6});
    const auto found = rows();
    ASSERT_EQ(found.size(), std::size_t{2});
    EXPECT_DOUBLE_EQ(*found[0].ns_per_particle_step, 50.0);  // 5 us over 100 particles
    EXPECT_DOUBLE_EQ(*found[0].ratio_to_textbook, 1.0);
    EXPECT_DOUBLE_EQ(*found[1].ns_per_particle_step, 10.0);
    EXPECT_DOUBLE_EQ(*found[1].ratio_to_textbook, 4.0);  // of 4, 4 and 5
    EXPECT_DOUBLE_EQ(*found[1].gflops, 20.0);
    EXPECT_DOUBLE_EQ(*found[1].fraction_of_peak, 0.2);
    EXPECT_FALSE(found[1].ms_per_frame.has_value());
}

TEST_F(BenchSuite, ATextbookTimedAlongIsNoRow) {
    add('t', "textbook", {4e-6, 4e-6, 4e-6});
    add('a', "rk4", {2e-6, 2e-6, 2e-6});
    group_.entries.front().shown = false;
    const auto found = rows();
    ASSERT_EQ(found.size(), std::size_t{1});
    EXPECT_DOUBLE_EQ(*found[0].ratio_to_textbook, 2.0);
}

TEST_F(BenchSuite, WhatDivergesSaysSoAndTheOthersGoOn) {
    add('t', "textbook", {4e-6, 4e-6, 4e-6});
    add('a', "forward-euler", {2e-6});
    const auto found = rows();
    EXPECT_EQ(turns_, "tatat");
    EXPECT_FALSE(found[0].diverged);
    EXPECT_TRUE(found[1].diverged);
    EXPECT_EQ(found[1].note, "it blew up");
    EXPECT_FALSE(found[1].ns_per_particle_step.has_value());
}

TEST_F(BenchSuite, WhatIsNotBuiltInSaysSo) {
    add('t', "textbook", {4e-6, 4e-6, 4e-6});
    add('a', "odeint rk4", {});
    group_.entries.back().make = nullptr;
    group_.entries.back().note = "not built in: Boost not found";
    const auto found = rows();
    EXPECT_EQ(found[1].note, "not built in: Boost not found");
    EXPECT_FALSE(found[1].ns_per_particle_step.has_value());
    EXPECT_FALSE(found[1].ratio_to_textbook.has_value());
    EXPECT_FALSE(found[1].diverged);
}

TEST_F(BenchSuite, StoppingLeavesNoRows) {
    add('t', "textbook", {4e-6, 4e-6, 4e-6});
    int asked = 0;
    EXPECT_TRUE(time_group(group_, machine_, 0.0, [&] { return ++asked > 2; }).empty());
    EXPECT_EQ(turns_, "t");
}

}  // namespace
}  // namespace weft::bench
