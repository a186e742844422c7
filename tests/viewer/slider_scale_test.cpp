#include "viewer/slider_scale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::viewer {
namespace {

TEST(SliderScale, EndsAreTheEnds) {
    for (const SliderScale& scale : {SliderScale{-20.0, 20.0, false}, SliderScale{1e-6, 0.1, true},
                                     SliderScale{0.0, 1e5, true}}) {
        EXPECT_EQ(scale.value_at(0.0), scale.low);
        EXPECT_EQ(scale.value_at(1.0), scale.high);
        EXPECT_EQ(scale.value_at(-3.0), scale.low);
        EXPECT_EQ(scale.value_at(7.0), scale.high);
        EXPECT_EQ(scale.place_of(scale.low), 0.0);
        EXPECT_EQ(scale.place_of(scale.high), 1.0);
        EXPECT_EQ(scale.place_of(2.0 * scale.high), 1.0);
    }
}

TEST(SliderScale, PlaceAndValueAgreeToTheirThreeDigits) {
    for (const SliderScale& scale : {SliderScale{-20.0, 20.0, false}, SliderScale{1e-6, 0.1, true},
                                     SliderScale{0.0, 1e5, true}}) {
        for (double place = 0.05; place < 1.0; place += 0.05) {
            EXPECT_NEAR(scale.place_of(scale.value_at(place)), place, 0.005);
        }
    }
}

TEST(SliderScale, ALogarithmicOneWithZeroMeetsItAtItsLeftEnd) {
    const SliderScale scale{0.0, 1e5, true};
    EXPECT_EQ(scale.value_at(0.01), 0.0);
    EXPECT_GT(scale.value_at(0.05), 0.0);
    EXPECT_EQ(scale.place_of(0.0), 0.0);
    EXPECT_LT(scale.place_of(0.0), scale.place_of(1e-3));
    EXPECT_LT(scale.place_of(1e-3), scale.place_of(1.0));
}

TEST(SliderScale, ALinearOneAcrossZeroMeetsIt) {
    const SliderScale scale{-20.0, 20.0, false};
    EXPECT_EQ(scale.value_at(0.5), 0.0);
    EXPECT_EQ(scale.value_at(0.50001), 0.0);
    EXPECT_EQ(scale.value_at(0.75), 10.0);
}

TEST(RoundedToDigits, KeepsThem) {
    EXPECT_EQ(rounded_to_digits(0.000123456, 3), 0.000123);
    EXPECT_EQ(rounded_to_digits(-98765.0, 2), -99000.0);
    EXPECT_EQ(rounded_to_digits(0.29999999, 3), 0.3);
    EXPECT_EQ(rounded_to_digits(0.0, 3), 0.0);
    EXPECT_TRUE(std::isinf(rounded_to_digits(INFINITY, 3)));
}

}  // namespace
}  // namespace weft::viewer
