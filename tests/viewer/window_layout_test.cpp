#include "viewer/window_layout.h"

#include <gtest/gtest.h>

namespace weft::viewer {
namespace {

float right_of(const Place& place) {
    return place.left + place.width;
}

TEST(WindowLayout, PartsFillTheWindowAndDoNotOverlap) {
    for (const float scale : {1.0F, 2.0F}) {
        for (float width = 480.0F; width <= 2560.0F; width += 40.0F) {
            for (const bool timeline : {false, true}) {
                const WindowLayout layout =
                    lay_out(scale * width, scale * 600.0F, scale * 15.0F, true, timeline);
                EXPECT_FLOAT_EQ(right_of(layout.change), layout.cloth.left);
                EXPECT_FLOAT_EQ(right_of(layout.cloth), scale * width - layout.know.width);
                EXPECT_FLOAT_EQ(layout.cloth.height + layout.bar.height, scale * 600.0F);
                EXPECT_FLOAT_EQ(layout.bar.top, layout.cloth.height);
                EXPECT_FLOAT_EQ(layout.bar.width, scale * width);
                EXPECT_GE(layout.cloth.width, scale * 14.0F * 15.0F - 0.01F);
            }
        }
    }
}

TEST(WindowLayout, BothPanelsAreThereAtTheSizesPromised) {
    for (const float width : {1280.0F, 900.0F}) {
        const WindowLayout layout = lay_out(width, 600.0F, 15.0F, true, false);
        EXPECT_GE(layout.change.width, 260.0F);
        EXPECT_EQ(layout.change.width, layout.know.width);
        EXPECT_GE(layout.cloth.width, 370.0F);
    }
}

TEST(WindowLayout, NarrowWindowsLoseTheRightPanelFirst) {
    const WindowLayout medium = lay_out(600.0F, 600.0F, 15.0F, true, false);
    EXPECT_GT(medium.change.width, 0.0F);
    EXPECT_EQ(medium.know.width, 0.0F);
    EXPECT_TRUE(medium.two_rows);
    const WindowLayout narrow = lay_out(460.0F, 600.0F, 15.0F, true, false);
    EXPECT_EQ(narrow.change.width, 0.0F);
}

TEST(WindowLayout, PanelsCanBeHidden) {
    const WindowLayout layout = lay_out(1280.0F, 720.0F, 15.0F, false, false);
    EXPECT_EQ(layout.cloth.left, 0.0F);
    EXPECT_EQ(layout.cloth.width, 1280.0F);
    EXPECT_FALSE(layout.two_rows);
    EXPECT_TRUE(lay_out(1280.0F, 720.0F, 15.0F, false, true).two_rows);
}

}  // namespace
}  // namespace weft::viewer
