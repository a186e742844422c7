// Lines and points in a picture: which pixels they cover, and behind what they vanish.
#include "render/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "render/canvas.h"
#include "render/overlay_shapes.h"

namespace weft {
namespace {

using test::Canvas;
using test::DrawnCloth;
using test::Pixel;

constexpr std::array<std::uint8_t, 4> green{0, 255, 0, 255};
const Pixel pure_green{0.0F, 255.0F, 0.0F};

/// A flat cloth in the plane z = 0, seen from the front or from behind.
class OverlayPicture : public testing::Test {
protected:
    void look_from(double z) {
        drawn.emplace(test::waving_grid(11, 7),
                      DrawnCloth::seen_from({0.75, 1.5, z}, {0.75, 1.5, 0.0}));
        drawn->draw(canvas, drawn->at_rest());
    }
    /// How many pixels of the column through `point` are green.
    [[nodiscard]] int green_in_column(glm::vec3 point) const {
        const std::size_t column = canvas.place_of(point, drawn->camera) % 480;
        const auto pixels = canvas.pixels();
        int count = 0;
        for (std::size_t row = 0; row < 270; ++row)
            count += pixels[row * 480 + column] == pure_green;
        return count;
    }
    [[nodiscard]] std::ptrdiff_t green_pixels() const {
        const auto pixels = canvas.pixels();
        return std::count(pixels.begin(), pixels.end(), pure_green);
    }
    void draw_level_line(float y, float z, float width) {
        const OverlayList lines{{{0.3F, y, z}, green}, {{1.2F, y, z}, green}};
        overlay.draw_lines(lines, width, drawn->camera, canvas.whole());
    }

    const Canvas canvas{480, 270};
    Overlay overlay;
    std::optional<DrawnCloth> drawn;
};

TEST_F(OverlayPicture, LineHasItsWidth) {
    look_from(4.0);
    draw_level_line(1.6F, 0.0F, 5.0F);
    EXPECT_NEAR(green_in_column({0.75F, 1.6F, 0.0F}), 4.5, 1.0);  // the rim of a pixel fades
    EXPECT_EQ(green_in_column({0.25F, 1.6F, 0.0F}), 0);
    EXPECT_EQ(green_in_column({1.25F, 1.6F, 0.0F}), 0);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(OverlayPicture, ThinLineIsOnePixelWide) {
    look_from(4.0);
    draw_level_line(1.6F, 0.0F, 1.0F);
    EXPECT_EQ(green_in_column({0.75F, 1.6F, 0.0F}), 1);
    EXPECT_EQ(green_in_column({0.25F, 1.6F, 0.0F}), 0);
}

TEST_F(OverlayPicture, LineOnTheClothIsSeenFromBothSides) {
    for (const double z : {4.0, -4.0})
        for (const float width : {1.0F, 3.0F}) {
            look_from(z);
            draw_level_line(1.6F, 0.0F, width);
            EXPECT_GE(green_in_column({0.75F, 1.6F, 0.0F}), 1) << z << " " << width;
        }
}

TEST_F(OverlayPicture, LineBehindTheClothIsHidden) {
    for (const double z : {4.0, -4.0})
        for (const float width : {1.0F, 3.0F}) {
            const float toward_eye = z > 0.0 ? 1.0F : -1.0F;
            look_from(z);
            draw_level_line(1.6F, -0.03F * toward_eye, width);
            EXPECT_EQ(green_pixels(), 0) << z << " " << width;
            draw_level_line(1.6F, 0.03F * toward_eye, width);
            EXPECT_GT(green_pixels(), 50);
        }
}

TEST_F(OverlayPicture, LineFromBehindTheEyeKeepsItsDirection) {
    look_from(4.0);
    const OverlayList lines{{{0.95F, 1.5F, 3.0F}, green}, {{0.95F, 1.5F, 9.0F}, green}};
    for (const float width : {1.0F, 3.0F}) {
        overlay.draw_lines(lines, width, drawn->camera, canvas.whole());
        const auto pixels = canvas.pixels();
        std::ptrdiff_t beside = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (pixels[i] != pure_green) continue;
            EXPECT_NEAR(static_cast<double>(i / 480), 135.0, 3.0);  // level through the middle
            EXPECT_GT(i % 480, 240U);                               // and rightward
            ++beside;
        }
        EXPECT_GT(beside, 60);
    }
}

TEST_F(OverlayPicture, PointIsRound) {
    look_from(4.0);
    const OverlayList points{{{0.75F, 1.6F, 0.0F}, green}};
    overlay.draw_points(points, 21.0F, drawn->camera, canvas.whole());
    const std::size_t middle = canvas.place_of({0.75F, 1.6F, 0.0F}, drawn->camera);
    const auto pixels = canvas.pixels();
    const auto is_greenish = [&](std::size_t i) {
        return pixels[i].r == 0.0F && pixels[i].b == 0.0F;
    };
    int covered = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) covered += is_greenish(i);
    EXPECT_NEAR(covered, 3.14 * 10.5 * 10.5, 45.0);
    EXPECT_EQ(pixels[middle], pure_green);
    EXPECT_TRUE(is_greenish(middle + 9));  // the rim, darker
    EXPECT_LT(pixels[middle + 9].g, 150.0F);
    EXPECT_FALSE(is_greenish(middle + 9 + 480 * 9));  // a corner of the square around it
}

TEST_F(OverlayPicture, PointsHideBehindTheClothAndLieOnIt) {
    for (const double z : {4.0, -4.0}) {
        const float toward_eye = z > 0.0 ? 1.0F : -1.0F;
        look_from(z);
        const OverlayList behind{{{0.75F, 1.6F, -0.03F * toward_eye}, green}};
        overlay.draw_points(behind, 4.0F, drawn->camera, canvas.whole());
        EXPECT_EQ(green_pixels(), 0);
        const OverlayList on_it{{{0.75F, 1.6F, 0.0F}, green}};
        overlay.draw_points(on_it, 4.0F, drawn->camera, canvas.whole());
        EXPECT_GE(green_pixels(), 4);
    }
}

TEST_F(OverlayPicture, StaysInItsRectangle) {
    look_from(4.0);
    canvas.wipe();
    const DrawTarget part = canvas.part(100, 60, 240, 135);
    const OverlayList marks{{{-9.0F, 1.5F, 0.0F}, green}, {{9.0F, 1.5F, 0.0F}, green}};
    overlay.draw_lines(marks, 9.0F, drawn->camera, part);
    overlay.draw_lines(marks, 1.0F, drawn->camera, part);
    const OverlayList edge{{{0.75F, 2.13F, 0.0F}, green}};
    overlay.draw_points(edge, 60.0F, drawn->camera, part);
    const auto pixels = canvas.pixels();
    int inside = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (pixels[i] == Canvas::paint) continue;
        const std::size_t column = i % 480, row = i / 480;
        ASSERT_TRUE(column >= 100 && column < 340 && row >= 60 && row < 195)
            << column << " " << row;
        ++inside;
    }
    EXPECT_GT(inside, 240 * 7);
    for (const int state : {GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_PROGRAM_POINT_SIZE})
        EXPECT_FALSE(glIsEnabled(static_cast<GLenum>(state)));
}

TEST_F(OverlayPicture, EmptyListsAndHalfALineDrawNothing) {
    look_from(4.0);
    const auto before = canvas.pixels();
    overlay.draw_lines({}, 3.0F, drawn->camera, canvas.whole());
    overlay.draw_points({}, 3.0F, drawn->camera, canvas.whole());
    const OverlayList half{{{0.75F, 1.6F, 0.1F}, green}};
    for (const float width : {1.0F, 3.0F})
        overlay.draw_lines(half, width, drawn->camera, canvas.whole());
    EXPECT_EQ(canvas.pixels(), before);
}

TEST_F(OverlayPicture, HundredThousandLinesAreAllDrawn) {
    look_from(4.0);
    OverlayList lines;
    for (int i = 0; i < 100000; ++i) {
        const float y = i == 99999 ? 1.6F : 30.0F;  // the last alone is in view
        lines.push_back({{0.3F, y, 0.0F}, green});
        lines.push_back({{1.2F, y, 0.0F}, green});
    }
    overlay.draw_lines(lines, 3.0F, drawn->camera, canvas.whole());
    EXPECT_GE(green_in_column({0.75F, 1.6F, 0.0F}), 2);
}

}  // namespace
}  // namespace weft
