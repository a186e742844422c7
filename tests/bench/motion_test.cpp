// The accuracy of motion: every method near the reference, more steps nearer.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "bench/suite/motion.h"
#include "weft/integrators.h"

namespace weft::bench {
namespace {

const MotionReference& reference() {
    static const MotionReference found = motion_reference();
    return found;
}

std::optional<MotionRow> measured(std::string_view name) {
    for (const MotionEntry& entry : motion_entries()) {
        if (entry.label.name == name) {
            return time_motion(entry, reference(), 1, [] { return false; });
        }
    }
    return std::nullopt;
}

TEST(Motion, EntriesAreMethodsThatExistEachOnce) {
    std::set<std::string> names;
    for (const MotionEntry& entry : motion_entries()) {
        EXPECT_NE(find_integrator(entry.method), nullptr) << entry.method;
        EXPECT_TRUE(names.insert(entry.label.name).second) << entry.label.name;
    }
    EXPECT_TRUE(names.contains("motion symplectic-euler"));
    EXPECT_TRUE(names.contains("motion vbd 50"));
    EXPECT_TRUE(names.contains("motion dopri5 1e-5"));
}

TEST(Motion, TheReferenceFellAndMoves) {
    EXPECT_EQ(reference().positions.size(), std::size_t{33 * 33});
    EXPECT_LT(reference().positions.back().y, -0.3);
    EXPECT_GT(reference().kinetic_energy, 0.1);
    EXPECT_LT(reference().kinetic_energy, 0.2 * 9.81 * 1.0);  // less than all of its fall
}

TEST(Motion, MoreStepsComeNearerAndLoseLess) {
    const auto coarse = measured("motion implicit-euler 1"), fine = measured("motion tr-bdf2 4"),
               free = measured("motion velocity-verlet");
    ASSERT_TRUE(coarse && coarse->figures && fine && fine->figures && free && free->figures);
    EXPECT_EQ(coarse->figures->steps_per_frame, 1.0);
    EXPECT_EQ(fine->figures->steps_per_frame, 4.0);
    EXPECT_GT(free->figures->steps_per_frame, 40.0);
    EXPECT_GT(coarse->figures->rms_error, 2.0 * fine->figures->rms_error);
    EXPECT_GT(fine->figures->rms_error, free->figures->rms_error);
    EXPECT_LT(coarse->figures->energy_change, -0.05);  // implicit Euler damps
    EXPECT_NEAR(free->figures->energy_change, 0.0, 0.005);
    for (const auto& row : {coarse, fine, free}) EXPECT_GT(row->figures->ms_per_frame, 0.0);
}

TEST(Motion, AMethodThatChoosesItsStepsSaysHowMany) {
    const auto row = measured("motion dopri5 1e-5");
    ASSERT_TRUE(row && row->figures);
    EXPECT_GT(row->figures->steps_per_frame, 10.0);
    EXPECT_LT(row->figures->rms_error, 0.05);
}

TEST(Motion, WhatCannotBeMadeSaysWhy) {
    const MotionEntry entry{"velocity-verlet", 1, {}, {"motion verlet 1", 33, 33, Precision::f64}};
    const auto row = time_motion(entry, reference(), 3, [] { return false; });
    ASSERT_TRUE(row.has_value());
    EXPECT_FALSE(row->figures.has_value());
    EXPECT_NE(row->note.find("diverged"), std::string::npos);
}

TEST(Motion, Stops) {
    EXPECT_FALSE(time_motion(motion_entries().front(), reference(), 3, [] { return true; }));
}

}  // namespace
}  // namespace weft::bench
