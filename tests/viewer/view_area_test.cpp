#include "viewer/view_area.h"

#include <gtest/gtest.h>

namespace weft::viewer {
namespace {

constexpr ViewArea window{300, 40, 1000, 600};

/// Areas lie inside, and none shares a pixel with another.
void expect_apart(const ViewArea& whole, const std::vector<ViewArea>& areas) {
    for (std::size_t a = 0; a < areas.size(); ++a) {
        const ViewArea& one = areas[a];
        EXPECT_GE(one.left, whole.left);
        EXPECT_GE(one.top, whole.top);
        EXPECT_LE(one.left + one.width, whole.left + whole.width);
        EXPECT_LE(one.top + one.height, whole.top + whole.height);
        for (std::size_t b = 0; b < a; ++b) {
            const ViewArea& other = areas[b];
            const bool apart =
                one.left >= other.left + other.width || other.left >= one.left + one.width ||
                one.top >= other.top + other.height || other.top >= one.top + one.height;
            EXPECT_TRUE(apart) << a << " and " << b;
        }
    }
}

TEST(ViewArea, OneClothHasAllOfIt) {
    const auto areas = split_area(window, 1);
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_EQ(areas[0].left, 300);
    EXPECT_EQ(areas[0].top, 40);
    EXPECT_EQ(areas[0].width, 1000);
    EXPECT_EQ(areas[0].height, 600);
}

TEST(ViewArea, ThreePixelsStandBetweenTwoAndNoneAreLost) {
    const auto areas = split_area(window, 2);
    ASSERT_EQ(areas.size(), 2U);
    EXPECT_EQ(areas[0].top, areas[1].top);
    EXPECT_EQ(areas[1].left - (areas[0].left + areas[0].width), 3);
    EXPECT_EQ(areas[0].width + areas[1].width, 997);
    EXPECT_EQ(areas[0].height, 600);
}

TEST(ViewArea, TwoStandOneAboveTheOtherWhereThatShowsThemLarger) {
    const auto areas = split_area({0, 0, 680, 600}, 2);
    EXPECT_EQ(areas[0].left, areas[1].left);
    EXPECT_EQ(areas[0].width, 680);
    EXPECT_EQ(areas[1].top - (areas[0].top + areas[0].height), 3);
}

TEST(ViewArea, TheThirdOfThreeHasARowOfItsOwn) {
    const auto areas = split_area(window, 3);
    ASSERT_EQ(areas.size(), 3U);
    EXPECT_EQ(areas[2].width, 1000);
    EXPECT_EQ(areas[0].top, areas[1].top);
    EXPECT_GT(areas[2].top, areas[0].top);
}

TEST(ViewArea, AreasAreApartInWindowsOfAnySize) {
    for (const int width : {1, 2, 7, 300, 1281})
        for (const int height : {1, 3, 200, 719})
            for (std::size_t count = 0; count <= 4; ++count) {
                const ViewArea whole{11, 13, width, height};
                const auto areas = split_area(whole, count);
                ASSERT_EQ(areas.size(), count);
                if (width > 6 && height > 6) expect_apart(whole, areas);
                for (const ViewArea& area : areas) {
                    EXPECT_GE(area.width, 0);
                    EXPECT_GE(area.height, 0);
                }
            }
}

TEST(ViewArea, FindsTheAreaOfAPixel) {
    const auto areas = split_area(window, 4);
    for (std::size_t n = 0; n < areas.size(); ++n) {
        const glm::vec2 inside(areas[n].left + areas[n].width - 1, areas[n].top);
        EXPECT_EQ(area_at(areas, inside), n);
    }
    EXPECT_EQ(area_at(areas, {299.0F, 100.0F}), std::nullopt);
    EXPECT_EQ(area_at(areas, {500.0F, 641.0F}), std::nullopt);
    const glm::vec2 in_the_gap(areas[0].left + areas[0].width + 1, 100);
    EXPECT_EQ(area_at(areas, in_the_gap), std::nullopt);
}

TEST(ViewArea, CursorRunsFromCornerToCorner) {
    EXPECT_EQ(cursor_in(window, {300.0F, 40.0F}), glm::vec2(-1.0F, 1.0F));
    EXPECT_EQ(cursor_in(window, {1300.0F, 640.0F}), glm::vec2(1.0F, -1.0F));
    EXPECT_EQ(cursor_in(window, {800.0F, 340.0F}), glm::vec2(0.0F, 0.0F));
}

TEST(ViewArea, ATargetIsShownInTheMiddleAndWhatIsBehindNotAtAll) {
    Camera camera;
    camera.eye = {3, 1, 4};
    camera.target = {1, 2, 0};
    const auto middle = pixel_of(window, camera, camera.target);
    ASSERT_TRUE(middle.has_value());
    EXPECT_NEAR(middle->x, 800.0F, 0.01F);
    EXPECT_NEAR(middle->y, 340.0F, 0.01F);
    EXPECT_FALSE(pixel_of(window, camera, 2.0F * camera.eye - camera.target).has_value());
    EXPECT_FALSE(pixel_of({0, 0, 0, 0}, camera, camera.target).has_value());
}

}  // namespace
}  // namespace weft::viewer
