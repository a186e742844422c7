// The gust of the first paper: each component of the wind times its own random factor.
#include <gtest/gtest.h>

#include <cmath>

#include "forces/wind.h"

namespace weft::test {
namespace {

constexpr double spread = 0.3, period = 0.25;  // [1], [s]

WindDescription gusty(std::uint64_t seed) {
    WindDescription wind;
    wind.velocity = {6.0, -2.0, 1.0};
    wind.gust = {GustModel::coefficient, spread, period, seed};
    return wind;
}

Vec3d factors(const WindDescription& wind, double time) {
    const Vec3d v = wind_velocity(wind, time);
    return {v.x / wind.velocity.x, v.y / wind.velocity.y, v.z / wind.velocity.z};
}

TEST(Gust, StaysWithinItsSpreadAndUsesAllOfIt) {
    const WindDescription wind = gusty(7);
    double low = 1.0, high = 1.0;
    for (double t = 0.0; t < 500.0; t += 0.0137) {
        const Vec3d f = factors(wind, t);
        for (const double c : {f.x, f.y, f.z}) {
            ASSERT_GE(c, 1.0 - spread - 1e-12);
            ASSERT_LE(c, 1.0 + spread + 1e-12);
            low = std::min(low, c);
            high = std::max(high, c);
        }
    }
    EXPECT_LT(low, 1.0 - 0.98 * spread);
    EXPECT_GT(high, 1.0 + 0.98 * spread);
}

// Draws are uniform: mean 1, variance spread^2 / 3; over 20000 draws the mean is known to 0.002.
TEST(Gust, HasMeanOneAndTheVarianceOfAUniformDraw) {
    const WindDescription wind = gusty(7);
    Vec3d sum{}, squares{};
    constexpr int draws = 20000;
    for (int n = 0; n < draws; ++n) {
        const Vec3d f = factors(wind, n * period) - Vec3d{1.0, 1.0, 1.0};
        sum += f;
        squares += Vec3d{f.x * f.x, f.y * f.y, f.z * f.z};
    }
    const double expected = spread * spread / 3.0;
    for (const double mean : {sum.x, sum.y, sum.z}) EXPECT_NEAR(mean / draws, 0.0, 0.005);
    for (const double s : {squares.x, squares.y, squares.z}) {
        EXPECT_NEAR(s / draws, expected, 0.03 * expected);
    }
}

// The cubic's slope is at most 3/2 of 2 spread over a period; it is zero at every draw.
TEST(Gust, IsSmooth) {
    const WindDescription wind = gusty(3);
    constexpr double h = 1e-4;
    Vec3d before = factors(wind, 0.0);
    for (double t = h; t < 20.0; t += h) {
        const Vec3d now = factors(wind, t);
        const double bound = 1.5 * 2.0 * spread / period * h * 1.0001;
        ASSERT_LE(std::abs(now.x - before.x), bound) << t;
        ASSERT_LE(std::abs(now.y - before.y), bound) << t;
        ASSERT_LE(std::abs(now.z - before.z), bound) << t;
        before = now;
    }
    for (int n = 1; n < 50; ++n) {
        const Vec3d change = factors(wind, n * period + h) - factors(wind, n * period - h);
        EXPECT_LT(std::abs(change.x) + std::abs(change.y) + std::abs(change.z), 1e-5);
    }
}

// Half way between two draws it is their mean.
TEST(Gust, BlendsBetweenDraws) {
    const WindDescription wind = gusty(3);
    for (int n = 0; n < 20; ++n) {
        const Vec3d a = factors(wind, n * period), b = factors(wind, (n + 1) * period);
        const Vec3d middle = factors(wind, (n + 0.5) * period);
        EXPECT_NEAR(middle.x, 0.5 * (a.x + b.x), 1e-12);
        const Vec3d quarter = factors(wind, (n + 0.25) * period);
        EXPECT_NEAR(quarter.z, a.z + (b.z - a.z) * 5.0 / 32.0, 1e-12);
    }
}

TEST(Gust, IsAFunctionOfSeedAndTime) {
    const WindDescription a = gusty(7), b = gusty(8);
    int same = 0;
    for (int n = 0; n < 100; ++n) {
        EXPECT_EQ(wind_velocity(a, n * 0.1), wind_velocity(gusty(7), n * 0.1));
        same += wind_velocity(a, n * 0.1) == wind_velocity(b, n * 0.1);
    }
    EXPECT_EQ(same, 0);
}

// Its components have their own factors.
TEST(Gust, TurnsTheWind) {
    const WindDescription wind = gusty(7);
    double correlation = 0.0;
    for (int n = 0; n < 5000; ++n) {
        const Vec3d f = factors(wind, n * period) - Vec3d{1.0, 1.0, 1.0};
        correlation += f.x * f.y + f.y * f.z + f.z * f.x;
    }
    EXPECT_NEAR(correlation / 5000 / (spread * spread / 3.0), 0.0, 0.1);
}

TEST(Wind, WithoutGustIsConstant) {
    WindDescription wind = gusty(7);
    wind.gust.model = GustModel::none;
    for (const double t : {0.0, 0.1, 1e6}) EXPECT_EQ(wind_velocity(wind, t), wind.velocity);
    wind.gust = {GustModel::coefficient, 0.0, period, 7};
    for (const double t : {0.0, 0.1, 1e6}) EXPECT_EQ(wind_velocity(wind, t), wind.velocity);
}

}  // namespace
}  // namespace weft::test
