// What stands in a picture: light, shadow, texture, edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <thread>
#include <vector>

#include "render/off_screen.h"
#include "support/recording.h"
#include "support/waving_cloth.h"
#include "weft/error.h"

namespace weft {
namespace {

using test::WavingCloth;
using Pixel = glm::vec3;  // red, green, blue in [0, 255]

RenderDescription small_picture(const std::string& texture) {
    RenderDescription render;
    render.size = {480, 270};
    render.texture = texture;
    return render;
}

double brightness(Pixel pixel) {
    return (pixel.r + pixel.g + pixel.b) / 3.0;
}

/// A picture of a cloth at rest together with the camera that took it.
class Shot {
public:
    Shot(const WavingCloth& cloth, const RenderDescription& render)
        : stage(plan_stage(cloth.surface, cloth.rest, render)) {
        OffScreenRenderer renderer(cloth.surface, render);
        image = renderer.draw({0, 0.0, cloth.rest, {}, {}});
        camera = choose_camera(stage, render);
    }

    [[nodiscard]] std::array<int, 2> place_of(glm::vec3 point) const {
        const auto width = static_cast<float>(image.width),
                   height = static_cast<float>(image.height);
        const glm::vec4 clip = camera.world_to_clip(width / height) * glm::vec4(point, 1.0F);
        return {static_cast<int>((0.5F + 0.5F * clip.x / clip.w) * width),
                static_cast<int>((0.5F - 0.5F * clip.y / clip.w) * height)};
    }
    /// Mean of 3 x 3 pixels where the point appears.
    [[nodiscard]] Pixel at(glm::vec3 point) const {
        const auto [x, y] = place_of(point);
        EXPECT_TRUE(x > 0 && x < image.width - 1 && y > 0 && y < image.height - 1);
        Pixel sum(0.0F);
        for (int row = y - 1; row <= y + 1; ++row)
            for (int column = x - 1; column <= x + 1; ++column) sum += pixel(column, row);
        return sum / 9.0F;
    }
    [[nodiscard]] Pixel pixel(int x, int y) const {
        const std::size_t i = 4 * static_cast<std::size_t>(y * image.width + x);
        return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
    }

    Stage stage;
    Camera camera;
    Image image;
};

TEST(Picture, HasTheSizeAskedForAndIsNotBlank) {
    WavingCloth cloth = test::waving_grid(31, 21);
    OffScreenRenderer renderer(cloth.surface, small_picture("flag"));
    const Image image = renderer.draw(cloth.frame(20));
    EXPECT_EQ(image.width, 480);
    EXPECT_EQ(image.height, 270);
    ASSERT_EQ(image.rgba.size(), 480U * 270U * 4U);
    std::set<std::array<std::uint8_t, 3>> colours;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        colours.insert({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
        ASSERT_EQ(image.rgba[i + 3], 255);
    }
    EXPECT_GT(colours.size(), 1000U);
}

TEST(Picture, SameFrameGivesTheSameBitsOnAnyThread) {
    WavingCloth cloth = test::waving_grid(31, 21);
    OffScreenRenderer renderer(cloth.surface, small_picture("linen"));
    const Frame frame = cloth.frame(7);
    const Image first = renderer.draw(frame);
    Image second;
    std::thread([&] { second = renderer.draw(frame); }).join();
    EXPECT_EQ(first.rgba, second.rgba);
}

TEST(Picture, ComputesNormalsWhereTheFrameHasNone) {
    WavingCloth cloth = test::waving_grid(31, 21);
    OffScreenRenderer renderer(cloth.surface, small_picture("plain"));
    Frame frame = cloth.frame(7);
    const Image with = renderer.draw(frame);
    frame.normals = {};
    EXPECT_EQ(with.rgba, renderer.draw(frame).rgba);
}

TEST(Picture, FrontIsLitInTheColourOfTheTexture) {
    WavingCloth cloth = test::waving_grid(31, 21);
    const Pixel middle = Shot(cloth, small_picture("plain")).at({0.75F, 1.5F, 0.0F});
    EXPECT_NEAR(middle.r, 190.0, 35.0);  // paint (201, 92, 74)
    EXPECT_NEAR(middle.g, 88.0, 30.0);
    EXPECT_NEAR(middle.b, 70.0, 30.0);
}

TEST(Picture, BackIsLitByWhatShinesThrough) {
    WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render = small_picture("plain");
    render.camera = Vec3d{0.75, 1.5, 3.0};
    const double front = brightness(Shot(cloth, render).at({0.75F, 1.5F, 0.0F}));
    render.camera = Vec3d{0.75, 1.5, -3.0};
    const double back = brightness(Shot(cloth, render).at({0.75F, 1.5F, 0.0F}));
    EXPECT_LT(back, 0.98 * front);  // the sun stands in front
    EXPECT_GT(back, 0.50 * front);
    EXPECT_GT(back, 60.0);
}

TEST(Picture, ClothShadesTheGroundWhereTheSunIsBehindIt) {
    WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render = small_picture("plain");
    render.camera = Vec3d{1.0, 4.0, 5.0};
    render.target = Vec3d{1.5, 0.3, -0.5};
    const Shot shot(cloth, render);
    const glm::vec3 middle{0.75F, 1.5F, 0.0F};
    const glm::vec3 shadow = middle - (middle.y / shot.stage.to_sun.y) * shot.stage.to_sun;
    ASSERT_NEAR(shadow.y, 0.0, 1e-5);
    const double shaded = brightness(shot.at(shadow));
    const double lit = brightness(shot.at(shadow + glm::vec3(0.0F, 0.0F, 1.4F)));
    EXPECT_LT(shaded, 0.7 * lit);
    EXPECT_GT(shaded, 0.2 * lit);  // the sky still lights it
}

TEST(Picture, MastCastsAShadowAndCanBeLeftOut) {
    WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render = small_picture("plain");
    render.camera = Vec3d{0.3, 1.4, 1.6};
    render.target = Vec3d{0.2, 0.3, -0.1};
    const Shot with(cloth, render);
    ASSERT_TRUE(with.stage.mast);
    const glm::vec3 on_mast{with.stage.mast->foot.x, 0.6F, with.stage.mast->foot.z};
    const glm::vec3 shadow = on_mast - (0.6F / with.stage.to_sun.y) * with.stage.to_sun;
    render.mast = false;
    const Shot without(cloth, render);
    EXPECT_GT(glm::distance(with.at(on_mast), without.at(on_mast)), 20.0F);
    EXPECT_LT(brightness(with.at(shadow)), 0.85 * brightness(without.at(shadow)));
}

/// A large panel in the plane z = 0, and a small one between its middle and the sun if `shaded`.
WavingCloth two_panels(bool shaded) {
    WavingCloth cloth = test::waving_grid(11, 11);
    if (!shaded) return cloth;
    const Stage stage = plan_stage(cloth.surface, cloth.rest, {});
    const glm::vec3 to_sun = stage.to_sun;
    const auto base = static_cast<std::uint32_t>(cloth.rest.size());
    for (const auto& [x, y] : {std::pair{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}) {
        cloth.rest.push_back({0.75 + 0.5 * to_sun.x + x, 1.5 + 0.5 * to_sun.y + y, 0.5 * to_sun.z});
        cloth.surface.uvs.push_back({0.5F, 0.5F});
    }
    test::add_quad(cloth.surface, base, base + 1, base + 2, base + 3);
    cloth.surface.particle_count = cloth.rest.size();
    return cloth;
}

TEST(Picture, ClothShadesItself) {
    RenderDescription render = small_picture("plain");
    render.camera = Vec3d{2.0, 1.2, 3.0};  // past the small panel
    render.target = Vec3d{0.75, 1.5, 0.0};
    double found[2] = {};
    for (const bool shaded : {false, true}) {
        WavingCloth cloth = two_panels(shaded);
        OffScreenRenderer renderer(cloth.surface, render);
        const Image image = renderer.draw({0, 0.0, cloth.rest, {}, {}});
        const std::size_t middle = 4 * (135 * 480 + 240);  // the target, mid-picture
        found[shaded ? 1 : 0] =
            (image.rgba[middle] + image.rgba[middle + 1] + image.rgba[middle + 2]) / 3.0;
    }
    EXPECT_LT(found[1], 0.75 * found[0]);
}

TEST(Picture, FlatClothDoesNotShadeItself) {
    WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render = small_picture("plain");
    render.camera = Vec3d{0.75, 1.5, 4.0};
    render.mast = false;
    for (Vec3d& point : cloth.rest) point.z = 0.0;
    OffScreenRenderer renderer(cloth.surface, render);
    const Image image = renderer.draw({0, 0.0, cloth.rest, {}, {}});
    int darkest = 255, brightest = 0;
    for (int y = 110; y < 160; ++y)
        for (int x = 190; x < 290; ++x) {
            const int red = image.rgba[4 * static_cast<std::size_t>(y * 480 + x)];
            darkest = std::min(darkest, red);
            brightest = std::max(brightest, red);
        }
    EXPECT_LE(brightest - darkest, 12);  // gloss alone differs from place to place
}

TEST(Picture, TextureStandsUprightAndUnmirrored) {
    const test::ScratchDirectory scratch;
    const Image four{2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}};
    const auto png = encode_png(four);
    test::write_text(scratch / "four.png", {reinterpret_cast<const char*>(png.data()), png.size()});
    WavingCloth cloth = test::waving_grid(31, 21);
    const Shot shot(cloth, small_picture((scratch / "four.png").string()));
    const Pixel top_left = shot.at({0.15F, 1.9F, 0.0F}), top_right = shot.at({1.35F, 1.9F, 0.0F});
    const Pixel low_left = shot.at({0.15F, 1.1F, 0.0F}), low_right = shot.at({1.35F, 1.1F, 0.0F});
    EXPECT_GT(top_left.r, 100.0F + top_left.g);
    EXPECT_GT(top_right.g, 100.0F + top_right.r);
    EXPECT_GT(low_left.b, 100.0F + low_left.r);
    EXPECT_GT(std::min({low_right.r, low_right.g, low_right.b}), 120.0F);
}

TEST(Picture, EdgesAreSmooth) {
    WavingCloth cloth = test::waving_grid(31, 21);
    RenderDescription render = small_picture("plain");
    render.mast = false;
    render.camera = Vec3d{0.2, 1.2, 4.0};  // so that the upper edge runs aslant
    const Shot shot(cloth, render);
    const float sky_blue = shot.at({0.75F, 2.1F, 0.0F}).b,
                cloth_blue = shot.at({0.75F, 1.8F, 0.0F}).b;
    ASSERT_GT(sky_blue, cloth_blue + 60.0F);
    int between = 0, columns = 0;
    for (int x = shot.place_of({0.2F, 2.0F, 0.0F})[0]; x < shot.place_of({1.3F, 2.0F, 0.0F})[0];
         ++x) {
        ++columns;
        for (int y = 0; y < shot.place_of({0.75F, 1.8F, 0.0F})[1]; ++y) {
            const float blue = shot.pixel(x, y).b;
            between += blue > cloth_blue + 20.0F && blue < sky_blue - 20.0F;
        }
    }
    ASSERT_GT(columns, 60);
    EXPECT_GT(between, columns / 2);  // with four samples three of four columns have one
}

TEST(Picture, MeshWithASeamIsDrawnWhole) {
    WavingCloth sleeve = test::waving_sleeve(24, 10);
    RenderDescription render = small_picture("plain");
    render.mast = false;
    const Pixel middle = Shot(sleeve, render).at({0.95F, 1.0F, 0.2F});
    EXPECT_GT(middle.r, middle.b + 40.0F);
}

TEST(Picture, GivenSizeIsRefusedWhereTheDriverHasNoRoom) {
    const WavingCloth cloth = test::waving_grid(5, 5);
    RenderDescription render = small_picture("plain");
    render.size = {200000, 200};
    try {
        const OffScreenRenderer renderer(cloth.surface, render);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_EQ(error.place().key, "render.size");
        EXPECT_NE(error.message().find("[200000, 200]"), std::string::npos);
    }
}

TEST(Picture, BadTextureIsAFileErrorAndTheNextPictureWorks) {
    WavingCloth cloth = test::waving_grid(5, 5);
    EXPECT_THROW(OffScreenRenderer(cloth.surface, small_picture("/nowhere/x.png")), Error);
    EXPECT_GT(brightness(Shot(cloth, small_picture("plain")).at({0.75F, 1.5F, 0.0F})), 50.0);
}

}  // namespace
}  // namespace weft
