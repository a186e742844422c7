// What a renderer draws where, with which options, and what it keeps from one frame to the next.
#include "render/renderer.h"

#include <gtest/gtest.h>

#include "render/canvas.h"

namespace weft {
namespace {

using test::brightness;
using test::Canvas;
using test::difference;
using test::DrawnCloth;
using test::Pixel;
using test::WavingCloth;

constexpr DrawOptions without_cloth{false, true, Effort::full, 1};
constexpr DrawOptions without_shadow{true, false, Effort::full, 1};
constexpr DrawOptions quick{true, true, Effort::quick, 1};

WavingCloth cloth() {
    return test::waving_grid(31, 21);
}

TEST(Renderer, FillsItsRectangleAndNothingElse) {
    const Canvas canvas(480, 270);
    DrawnCloth drawn(cloth());
    const Frame frame = drawn.cloth.frame(7);
    for (const Effort effort : {Effort::full, Effort::quick}) {
        canvas.wipe();
        drawn.renderer.draw(frame, drawn.camera, canvas.part(37, 20, 301, 190),
                            {true, true, effort, 1});
        const auto pixels = canvas.pixels();
        std::size_t untouched = 0;
        for (std::size_t row = 0; row < 270; ++row)
            for (std::size_t column = 0; column < 480; ++column) {
                const bool inside =
                    column >= 37 && column < 37 + 301 && row >= 20 && row < 20 + 190;
                const bool painted = pixels[row * 480 + column] == Canvas::paint;
                ASSERT_EQ(painted, !inside) << row << " " << column;
                untouched += painted ? 1 : 0;
            }
        EXPECT_EQ(untouched, 480U * 270U - 301U * 190U);
    }
}

TEST(Renderer, PictureInARectangleIsThatOfAWholeTarget) {
    std::vector<Pixel> cut;
    {
        const Canvas canvas(480, 270);
        DrawnCloth drawn(cloth());
        drawn.renderer.draw(drawn.cloth.frame(7), drawn.camera, canvas.part(100, 60, 240, 135));
        const auto pixels = canvas.pixels();
        for (std::size_t row = 60; row < 60 + 135; ++row)
            for (std::size_t column = 100; column < 100 + 240; ++column)
                cut.push_back(pixels[row * 480 + column]);
    }
    const Canvas small(240, 135);
    DrawnCloth drawn(cloth());
    drawn.renderer.draw(drawn.cloth.frame(7), drawn.camera, small.whole());
    EXPECT_LT(difference(cut, small.pixels()), 0.7F);  // the dither alone differs
}

TEST(Renderer, LeavesTestsAndBlendingOff) {
    const Canvas canvas(480, 270);
    DrawnCloth drawn(cloth());
    for (const Effort effort : {Effort::full, Effort::quick}) {
        drawn.draw(canvas, drawn.at_rest(), {true, true, effort, 1});
        for (const int state :
             {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND, GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL})
            EXPECT_FALSE(glIsEnabled(static_cast<GLenum>(state))) << state;
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

TEST(Renderer, WithoutClothShowsWhatIsBehindItAndNoShadowOfIt) {
    const Canvas canvas(480, 270);
    DrawnCloth drawn(cloth(), DrawnCloth::seen_from({1.0, 4.0, 5.0}, {1.5, 0.3, -0.5}));
    const glm::vec3 middle{0.75F, 1.5F, 0.0F};
    const std::size_t on_cloth = canvas.place_of(middle, drawn.camera);
    const std::size_t in_shadow = canvas.place_of(
        middle - (middle.y / drawn.stage.to_sun.y) * drawn.stage.to_sun, drawn.camera);
    const auto with = drawn.draw(canvas, drawn.at_rest());
    const auto without = drawn.draw(canvas, drawn.at_rest(), without_cloth);
    EXPECT_GT(with[on_cloth].r, 1.5F * with[on_cloth].b);  // the paint is red
    EXPECT_LT(without[on_cloth].r, 1.2F * without[on_cloth].b);
    EXPECT_LT(brightness(with[in_shadow]), 0.7F * brightness(without[in_shadow]));
}

TEST(Renderer, WithoutShadowReadsNoMapOfAnEarlierPicture) {
    for (const Effort effort : {Effort::full, Effort::quick}) {
        const Canvas canvas(480, 270);
        DrawOptions bare = without_shadow, shaded = {};
        bare.effort = shaded.effort = effort;
        DrawnCloth fresh(cloth());
        const auto expected = fresh.draw(canvas, fresh.cloth.frame(9), bare);
        DrawnCloth used(cloth());
        const auto with = used.draw(canvas, used.cloth.frame(9), shaded);
        EXPECT_EQ(used.draw(canvas, used.cloth.frame(9), bare), expected);
        EXPECT_GT(difference(with, expected), 1.0F);
    }
}

TEST(Renderer, KeepsNothingOfAnEarlierFrame) {
    for (const Effort effort : {Effort::full, Effort::quick}) {
        const Canvas canvas(480, 270);
        const DrawOptions options{true, true, effort, 1};
        DrawnCloth fresh(cloth());
        const auto expected = fresh.draw(canvas, fresh.cloth.frame(9), options);
        DrawnCloth used(cloth());
        const auto earlier = used.draw(canvas, used.cloth.frame(2), options);
        EXPECT_EQ(used.draw(canvas, used.cloth.frame(9), options), expected);
        EXPECT_EQ(used.draw(canvas, used.cloth.frame(9), options), expected);  // map is kept
        EXPECT_EQ(used.draw(canvas, used.cloth.frame(2), options), earlier);
    }
}

TEST(Renderer, SwitchesBetweenOptionsAsIfEachWereTheFirst) {
    const Canvas canvas(480, 270);
    DrawnCloth drawn(cloth());
    std::vector<std::vector<Pixel>> first;
    const std::vector<DrawOptions> all{{},
                                       quick,
                                       without_shadow,
                                       without_cloth,
                                       {true, true, Effort::quick, 2},
                                       {true, true, Effort::full, 3}};
    for (const DrawOptions& options : all) {
        DrawnCloth fresh(cloth());
        first.push_back(fresh.draw(canvas, fresh.cloth.frame(5), options));
    }
    for (int round = 0; round < 2; ++round)
        for (std::size_t i = 0; i < all.size(); ++i)
            EXPECT_EQ(drawn.draw(canvas, drawn.cloth.frame(5), all[i]), first[i]) << i;
}

TEST(Renderer, QuickPictureIsNearlyTheFullOne) {
    const Canvas canvas(480, 270);
    for (const bool mast : {true, false}) {
        RenderDescription render = DrawnCloth::plain();
        render.texture = "flag";
        render.mast = mast;
        DrawnCloth drawn(cloth(), render);
        const Frame frame = drawn.cloth.frame(13);
        EXPECT_LT(difference(drawn.draw(canvas, frame), drawn.draw(canvas, frame, quick)), 2.5F);
    }
}

TEST(Renderer, QuickPictureOfADegenerateClothIsWhole) {
    const Canvas canvas(480, 270);
    DrawnCloth drawn(cloth());
    const std::vector<Vec3d> crumpled(drawn.cloth.rest.size(), Vec3d{0.5, 1.0, 0.0});
    for (const Pixel& pixel : drawn.draw(canvas, {0, 0.0, crumpled, {}, {}}, quick))
        ASSERT_NE(pixel, Canvas::paint);
}

TEST(Renderer, CoarserClothLooksAlike) {
    const Canvas canvas(480, 270);
    DrawnCloth drawn(test::waving_grid(121, 81));
    const Frame frame = drawn.cloth.frame(13);
    const auto whole = drawn.draw(canvas, frame);
    EXPECT_LT(difference(whole, drawn.draw(canvas, frame, {true, true, Effort::full, 2})), 0.5F);
    EXPECT_GT(difference(whole, drawn.draw(canvas, frame, {true, true, Effort::full, 40})), 0.5F);
}

}  // namespace
}  // namespace weft
