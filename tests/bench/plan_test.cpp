// Which cases are timed: all of them once, in groups with their yardstick.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bench/suite/plan.h"
#include "support/methods.h"
#include "weft/error.h"
#include "weft/integrators.h"

namespace weft::bench {
namespace {

std::vector<std::string> labels(const Plan& plan) {
    std::vector<std::string> texts;
    for (const Group& group : plan.groups) {
        for (const Entry& entry : group.entries) {
            if (entry.shown) texts.push_back(entry.label.text());
        }
    }
    for (const FrameGroup& group : plan.frames) {
        for (const FrameEntry& entry : group.entries) {
            if (entry.shown) texts.push_back(entry.label.text());
        }
    }
    for (const MotionEntry& entry : plan.motions) texts.push_back(entry.label.text());
    return texts;
}

bool contains(const std::vector<std::string>& texts, const std::string& text) {
    return std::ranges::find(texts, text) != texts.end();
}

TEST(BenchPlan, EveryCaseIsThereOnce) {
    const auto texts = labels(make_plan({}, 2));
    EXPECT_EQ(std::set(texts.begin(), texts.end()).size(), texts.size());
    for (const IntegratorInfo& info : test::explicit_methods()) {
        for (const char* size : {"40x40", "100x100", "256x256", "512x512", "1024x1024"}) {
            for (const char* precision : {"single", "double"}) {
                const std::string begin = std::string(info.name) + " " + size + " " + precision;
                EXPECT_TRUE(contains(texts, begin + " 1 thread")) << begin;
            }
        }
        EXPECT_TRUE(contains(texts, std::string(info.name) + " 256x256 single 2 threads"));
    }
    for (const char* text :
         {"textbook 40x40 double 1 thread", "textbook 1000x1000 double 1 thread",
          "symplectic-euler 1000x1000 single 1 thread", "odeint rk4 256x256 double 1 thread",
          "odeint velocity_verlet 256x256 double 1 thread",
          "mesh symplectic-euler 256x256 single 1 thread", "flag with wind 256x256 single 1 thread",
          "flag without wind 256x256 single 1 thread",
          "pinned copies symplectic-euler 1024x1024 single 2 threads",
          "bullet soft body at 60 Hz 40x40 single 1 thread",
          "velocity-verlet at 60 Hz 40x40 single 1 thread", "hanging auto 100x100 single 1 thread",
          "hanging bullet-deformable 40x40 single 1 thread",
          "implicit frame multigrid 513x513 double 1 thread",
          "implicit frame cholesky 257x257 double 1 thread",
          "implicit frame projective-dynamics 41x41 double 1 thread",
          "motion velocity-verlet 33x33 double 1 thread",
          "motion implicit-euler 16 33x33 double 1 thread",
          "motion dopri5 1e-4 33x33 double 1 thread"}) {
        EXPECT_TRUE(contains(texts, text)) << text;
    }
}

TEST(BenchPlan, ARatioAlwaysHasItsTextbookInTheSameGroup) {
    for (const char* filter : {"", "rk4", "mesh", "1024x1024 2 threads"}) {
        for (const Group& group : make_plan({.filter = filter}, 2).groups) {
            const auto count = std::ranges::count_if(group.entries, [](const Entry& entry) {
                return entry.label.name == textbook_name;
            });
            const bool wanted = std::ranges::any_of(
                group.entries, [](const Entry& e) { return e.shown && e.against_textbook; });
            EXPECT_EQ(count, wanted ? 1 : 0) << filter;
        }
    }
}

TEST(BenchPlan, TargetsHaveFiveRepeatsTheRestThree) {
    for (const Group& group : make_plan({}, 2).groups) {
        const Label& label = group.entries.back().label;
        const bool target = (label.name == "symplectic-euler" && label.threads == 1) ||
                            label.name == "odeint rk4" || label.name.starts_with("mesh") ||
                            label.name.starts_with("flag");
        EXPECT_EQ(group.repeats, target ? 5 : 3) << label.text();
    }
    EXPECT_EQ(make_plan({.repeats = 9}, 2).groups.front().repeats, 9);
}

TEST(BenchPlan, AFilterKeepsWhatHasAllItsWords) {
    const auto texts = labels(make_plan({.filter = "rk4  256x256 double 1 thread"}, 2));
    EXPECT_EQ(texts, (std::vector<std::string>{"rk4 256x256 double 1 thread",
                                               "odeint rk4 256x256 double 1 thread"}));
    for (const std::string& text : labels(make_plan({.filter = "mesh"}, 2))) {
        EXPECT_NE(text.find("mesh"), std::string::npos);
    }
}

TEST(BenchPlan, AFilterHasWholeWords) {
    const Label label{"motion implicit-euler 16", 33, 33, Precision::f64, 1};
    EXPECT_TRUE(label.has_words(""));
    EXPECT_TRUE(label.has_words(" 33x33  motion "));
    EXPECT_TRUE(label.has_words("16 double 1 thread"));
    EXPECT_FALSE(label.has_words("implicit"));
    EXPECT_FALSE(label.has_words("motion 3"));
    for (const std::string& text : labels(make_plan({.filter = "implicit"}, 2))) {
        EXPECT_TRUE(text.starts_with("implicit frame ")) << text;
    }
}

TEST(BenchPlan, ImplicitFramesHaveTheirYardstickAlong) {
    const Plan plan = make_plan({.filter = "implicit multigrid"}, 2);
    EXPECT_TRUE(plan.groups.empty() && plan.motions.empty());
    ASSERT_EQ(plan.frames.size(), std::size_t{4});
    for (const FrameGroup& group : plan.frames) {
        EXPECT_EQ(group.repeats, 3);
        const bool cholesky = group.size <= 257;
        ASSERT_EQ(group.entries.size(), std::size_t{cholesky ? 2u : 1u}) << group.size;
        EXPECT_TRUE(group.entries.front().shown);
        if (!cholesky) continue;
        EXPECT_EQ(group.entries.back().label.name, cholesky_frame_name);
        EXPECT_FALSE(group.entries.back().shown);
    }
    EXPECT_EQ(make_plan({.filter = "implicit", .repeats = 7}, 2).frames.front().repeats, 7);
}

TEST(BenchPlan, AFilterThatMatchesNothingIsRefused) {
    try {
        (void)make_plan({.filter = "rk5"}, 2);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_STREQ(error.what(), "--filter \"rk5\": no case has all of these words");
        EXPECT_NE(error.detail().find("rk4 256x256 single 1 thread"), std::string::npos);
    }
}

TEST(BenchPlan, QuickEndsAt256AndLargeAt4096) {
    int largest = 0;
    for (const Group& group : make_plan({.quick = true}, 2).groups) {
        EXPECT_EQ(group.repeats, 1);
        for (const Entry& entry : group.entries) largest = std::max(largest, entry.label.columns);
    }
    EXPECT_EQ(largest, 256);
    EXPECT_EQ(make_plan({.quick = true}, 2).frames.back().size, 97);
    EXPECT_EQ(make_plan({.quick = true}, 2).motion_repeats, 1);
    EXPECT_TRUE(contains(labels(make_plan({.large = true}, 2)),
                         "growth symplectic-euler 4096x4096 single 1 thread"));
}

TEST(BenchPlan, OneHardwareThreadHasNothingToShare) {
    const Plan plan = make_plan({}, 1);
    EXPECT_FALSE(plan.needs_copies);
    for (const std::string& text : labels(plan)) EXPECT_TRUE(text.ends_with("1 thread")) << text;
    EXPECT_TRUE(make_plan({}, 2).needs_copies);
    EXPECT_FALSE(make_plan({.filter = "rk4"}, 2).needs_copies);
}

}  // namespace
}  // namespace weft::bench
