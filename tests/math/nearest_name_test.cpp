// Distances between names, and the one that was meant.
#include "math/nearest_name.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace weft {
namespace {

TEST(EditDistance, CountsChangesOfOneLetter) {
    EXPECT_EQ(edit_distance("", ""), 0U);
    EXPECT_EQ(edit_distance("rk4", "rk4"), 0U);
    EXPECT_EQ(edit_distance("", "rk4"), 3U);
    EXPECT_EQ(edit_distance("rk44", "rk4"), 1U);       // left out
    EXPECT_EQ(edit_distance("r4", "rk4"), 1U);         // put in
    EXPECT_EQ(edit_distance("rk3", "rk4"), 1U);        // replaced
    EXPECT_EQ(edit_distance("fabirc", "fabric"), 1U);  // swapped
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(NearestName, IsTheFirstOfTheNearest) {
    constexpr std::array<std::string_view, 4> names{"rk2", "rk3", "rk4", "velocity-verlet"};
    EXPECT_EQ(nearest_name("rk5", names), "rk2");
    EXPECT_EQ(nearest_name("rk44", names), "rk4");
    EXPECT_EQ(nearest_name("velocty_verlet", names), "velocity-verlet");
    EXPECT_EQ(nearest_name("bogus", names), "");
    EXPECT_EQ(nearest_name("", names), "");
    EXPECT_EQ(nearest_name(std::string(100000, 'r'), names), "");
}

TEST(DidYouMean, IsEmptyWhereNothingIsNear) {
    constexpr std::array<std::string_view, 1> names{"flag"};
    EXPECT_EQ(did_you_mean("flga", names), " (did you mean flag?)");
    EXPECT_EQ(did_you_mean("curtain", names), "");
}

}  // namespace
}  // namespace weft
