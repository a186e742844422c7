// Random numbers: the published numbers of SplitMix64, and their distribution.
#include <gtest/gtest.h>

#include <set>

#include "math/random.h"

namespace weft::test {
namespace {

// The first outputs of SplitMix64 from seed 0, as its authors publish them.
TEST(Random, MixesAsSplitMix64) {
    EXPECT_EQ(mix_bits(0), 0xe220a8397b1dcdafu);
    EXPECT_EQ(mix_bits(0x9e3779b97f4a7c15u), 0x6e789e6aa1b965f4u);
    EXPECT_EQ(mix_bits(2 * 0x9e3779b97f4a7c15u), 0x06c45d188009454fu);
}

TEST(Random, IsUniformAndAFunctionOfItsKey) {
    double sum = 0.0, squares = 0.0;
    constexpr int count = 100'000;
    std::set<double> values;
    for (int n = 0; n < count; ++n) {
        const double u = random_uniform(5, 2, static_cast<std::uint64_t>(n));
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        sum += u;
        squares += u * u;
        values.insert(u);
    }
    EXPECT_NEAR(sum / count, 0.5, 0.003);
    EXPECT_NEAR(squares / count, 1.0 / 3.0, 0.003);
    EXPECT_EQ(values.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(random_uniform(5, 2, 9), random_uniform(5, 2, 9));
    EXPECT_NE(random_uniform(5, 2, 9), random_uniform(6, 2, 9));
    EXPECT_NE(random_uniform(5, 2, 9), random_uniform(5, 3, 9));
}

}  // namespace
}  // namespace weft::test
