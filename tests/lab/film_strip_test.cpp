// Words, tiles and strips: what stands where in the pictures.
#include "lab/look/film_strip.h"

#include <gtest/gtest.h>

#include <array>

#include "lab/look/picture_text.h"
#include "lab/wrinkles.h"
#include "render/camera.h"
#include "render/stage.h"
#include "support/cloth_scenes.h"

namespace weft::lab {
namespace {

std::array<int, 3> pixel(const Image& image, int x, int y) {
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
             static_cast<std::size_t>(x));
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

constexpr std::array<int, 3> white{255, 255, 255}, black{0, 0, 0}, red{178, 24, 43},
    grey{226, 229, 234};

int count_of(const Image& image, std::array<int, 3> colour) {
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) count += pixel(image, x, y) == colour ? 1 : 0;
    }
    return count;
}

TEST(PictureText, WritesWithinItsWidthAndLine) {
    Image image = blank_image(200, 40, {255, 255, 255});
    draw_text(image, 10, 8, "rk4, dt = 1 ms", {0, 0, 0}, 2);
    EXPECT_GT(count_of(image, black), 150);
    const int right = 10 + text_width("rk4, dt = 1 ms", 2);
    EXPECT_GT(right, 120);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (pixel(image, x, y) == white) continue;
            EXPECT_TRUE(x >= 10 && x < right && y >= 8 && y < 8 + text_height(2)) << x << " " << y;
        }
    }
    EXPECT_EQ(text_width("verlet", 2), 2 * text_width("verlet", 1));
}

TEST(PictureText, IsCutAtThePicturesEdge) {
    Image image = blank_image(30, 10, {255, 255, 255});
    draw_text(image, -5, -5, "velocity-verlet", {0, 0, 0}, 3);
    fill_rectangle(image, 25, 5, 100, 100, {178, 24, 43});
    EXPECT_EQ(pixel(image, 29, 9), red);
    EXPECT_EQ(image.rgba.size(), 4u * 30u * 10u);
}

TEST(PictureText, PastesAndFrames) {
    Image image = blank_image(20, 10, {255, 255, 255});
    Image part = blank_image(8, 6, {0, 0, 0});
    draw_border(part, 2, {178, 24, 43});
    paste(image, part, 15, -1);
    EXPECT_EQ(pixel(image, 14, 0), white);
    EXPECT_EQ(pixel(image, 15, 0), red);
    EXPECT_EQ(pixel(image, 17, 2), black);
    EXPECT_EQ(pixel(image, 19, 5), white);
}

// Two flights of a hanging sheet: one to the end, one torn apart after the first picture.
class FilmStripTest : public ::testing::Test {
protected:
    FilmStripTest() : cloth_(build_cloth(test::bare_sheet(7, 6))) {
        for (std::size_t p = 0; p < cloth_.particle_count; ++p) {
            start_.push_back(cloth_.rest_position(p));
        }
        for (int n = 0; n < 3; ++n) {
            Shape shape = start_;
            for (Vec3d& x : shape) x.z += 0.1 * n * x.x;
            good_.shapes.push_back(shape);
        }
        bad_.shapes = {good_.shapes[0]};
        bad_.failed = 0.25;
        bad_.failure = blown_up;
        bad_.last = good_.shapes[1];
        rows_ = {{"verlet", &good_}, {"forward-euler", &bad_}};
        render_.size = {160, 120};
        render_.mast = false;
    }

    ClothModel cloth_;
    Shape start_;
    LookFlight good_, bad_;
    std::vector<StripRow> rows_;
    std::vector<StripColumn> columns_{{"0 s", 0}, {"0.5 s", 1}, {"1 s", 2}};
    RenderDescription render_;
};

TEST_F(FilmStripTest, ShowsEveryFlightAtEveryTimeAndMarksTheOneThatFailed) {
    TilePainter painter(cloth_.surface, render_, start_);
    int checks = 0;
    const Image strip = paint_strip(painter, rows_, columns_, [&] { ++checks; });
    EXPECT_EQ(checks, 6);
    EXPECT_EQ(strip.width, 3 * 164 + 4);
    EXPECT_EQ(strip.height, 2 * (120 + 22 + 4) + 22 + 4);
    const auto tile_left = [](int column) { return 4 + 164 * column; };
    const auto tile_top = [](int row) { return 22 + 146 * row + 22; };
    // The failed flight: as the other at first, then framed in red, then empty.
    EXPECT_EQ(pixel(strip, tile_left(0) + 80, tile_top(1) + 60),
              pixel(strip, tile_left(0) + 80, tile_top(0) + 60));
    EXPECT_EQ(pixel(strip, tile_left(1), tile_top(1)), red);
    EXPECT_EQ(pixel(strip, tile_left(1) + 159, tile_top(1) + 119), red);
    EXPECT_NE(pixel(strip, tile_left(1) + 80, tile_top(1) + 50), grey);
    EXPECT_EQ(pixel(strip, tile_left(2) + 80, tile_top(1) + 50), grey);
    EXPECT_NE(pixel(strip, tile_left(2) + 80, tile_top(0) + 50), grey);
    // Its words are red, the other's dark.
    const auto words_of = [&](int row) {
        Image line = blank_image(160, 22, {255, 255, 255});
        Image copy = strip;
        paste(line, copy, -4, -(22 + 146 * row));
        return line;
    };
    EXPECT_GT(count_of(words_of(1), red), 50);
    EXPECT_EQ(count_of(words_of(0), red), 0);
}

TEST_F(FilmStripTest, IsTheSamePictureTwice) {
    std::vector<std::uint8_t> first;
    for (int n = 0; n < 2; ++n) {
        TilePainter painter(cloth_.surface, render_, start_);
        const Image strip = paint_strip(painter, rows_, columns_, [] {});
        if (n == 0) first = strip.rgba;
        EXPECT_TRUE(strip.rgba == first);
    }
}

TEST_F(FilmStripTest, OneCameraShowsEveryShapeThatDidNotFail) {
    bad_.last.front() = {1000.0, 0.0, 0.0};  // must not count
    bad_.shapes[0].front() = {1000.0, 0.0, 0.0};
    const RenderDescription fixed = with_common_camera(cloth_.surface, render_, start_, rows_);
    ASSERT_TRUE(fixed.camera && fixed.target);
    const Camera camera = choose_camera(plan_stage(cloth_.surface, start_, fixed), fixed);
    double reach = 0.0;
    for (const Shape& shape : good_.shapes) {
        for (const Vec3d& x : shape) {
            const glm::vec4 clip = camera.world_to_clip(160.0F / 120.0F) * glm::vec4(to_glm(x), 1);
            EXPECT_LT(std::abs(clip.x / clip.w), 1.0F);
            EXPECT_LT(std::abs(clip.y / clip.w), 1.0F);
            reach = std::max<double>(reach, std::abs(clip.y / clip.w));
        }
    }
    EXPECT_GT(reach, 0.5);  // and not from far away
    RenderDescription given = render_;
    given.camera = Vec3d{1.0, 2.0, 3.0};
    EXPECT_EQ(with_common_camera(cloth_.surface, given, start_, rows_).camera, given.camera);
}

TEST_F(FilmStripTest, AVideosFrameHasEveryFlightWithItsName) {
    TilePainter painter(cloth_.surface, render_, start_);
    const TileGrid grid(painter.width(), painter.height(), 5);
    EXPECT_EQ(grid.width(), 3 * 160);
    EXPECT_EQ(grid.height(), 2 * (120 + 22));
    const TileGrid odd(161, 121, 1);
    EXPECT_EQ(odd.width() % 2, 0);
    EXPECT_EQ(odd.height() % 2, 0);
    const Image frame = grid.paint(painter, rows_, 2, [] {});
    EXPECT_NE(pixel(frame, 80, 22 + 60), white);
    EXPECT_EQ(pixel(frame, 160, 22), red);              // the second failed
    EXPECT_EQ(pixel(frame, 320 + 80, 22 + 60), white);  // there is no third
}

TEST(FilmStrip, CanBeMadeHere) {
    EXPECT_EQ(why_no_pictures(), "");
}

TEST(FilmStrip, TellsWhyThereAreNoPictures) {
    // A new process, since EGL reads the variable once.
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere/driver.json", 1);
            std::fputs(why_no_pictures().c_str(), stderr);
            std::_Exit(0);
        },
        testing::ExitedWithCode(0), "OpenGL 3.3 through EGL");
}

}  // namespace
}  // namespace weft::lab
