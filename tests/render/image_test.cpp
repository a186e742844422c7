// Textures and PNG files.
#include "render/image.h"

#include <gtest/gtest.h>
#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "support/recording.h"
#include "weft/error.h"

namespace weft {
namespace {

using test::ScratchDirectory;

std::array<int, 3> pixel_at(const Image& image, int x, int y) {
    const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(x));
    return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}

/// Every byte differs from its neighbours; alpha is 255 where `opaque`.
Image noise_image(int width, int height, bool opaque) {
    Image image{width, height, {}};
    std::uint32_t state = 12345;
    for (int i = 0; i < width * height * 4; ++i) {
        state = state * 1664525U + 1013904223U;
        const bool alpha = i % 4 == 3;
        image.rgba.push_back(alpha && opaque ? 255 : static_cast<std::uint8_t>(state >> 24));
    }
    return image;
}

std::string text_of(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

Error error_of(const std::string& texture) {
    try {
        load_texture(texture);
    } catch (const Error& error) {
        return error;
    }
    throw std::logic_error("no error for " + texture);
}

TEST(TextureCatalogue, PaintsEveryRowOpaque) {
    std::vector<std::string_view> names;
    for (const TextureInfo& info : texture_catalogue()) {
        names.push_back(info.name);
        EXPECT_FALSE(info.description.empty());
        const Image image = load_texture(std::string(info.name));
        ASSERT_EQ(image.rgba.size(), static_cast<std::size_t>(image.width * image.height * 4));
        for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);
    }
    EXPECT_EQ(names,
              (std::vector<std::string_view>{"flag", "checker", "stripes", "linen", "plain"}));
}

TEST(TextureCatalogue, FlagHasItsColoursInTheirPlaces) {
    const Image flag = load_texture("flag");
    EXPECT_EQ(flag.width, 1536);
    EXPECT_EQ(flag.height, 1024);
    EXPECT_EQ(pixel_at(flag, 500, 100), (std::array{35, 47, 112}));   // indigo field
    EXPECT_EQ(pixel_at(flag, 1400, 512), (std::array{226, 78, 58}));  // coral toward the fly
    EXPECT_EQ(pixel_at(flag, 481, 512), (std::array{246, 184, 60}));  // gold in the knot's middle
    EXPECT_EQ(pixel_at(flag, 10, 512), (std::array{238, 232, 219}));  // canvas at the hoist
}

TEST(TextureCatalogue, CheckerIsEightByEight) {
    const Image image = load_texture("checker");
    int changes = 0;
    for (int x = 1; x < image.width; ++x)
        changes += pixel_at(image, x, 5) != pixel_at(image, x - 1, 5);
    EXPECT_EQ(changes, 7);
    EXPECT_NE(pixel_at(image, 5, 5), pixel_at(image, 5, 133));
}

TEST(Png, KeepsEveryByteWithAndWithoutAlpha) {
    const ScratchDirectory scratch;
    for (const bool opaque : {true, false}) {
        const Image image = noise_image(37, 23, opaque);
        test::write_text(scratch / "noise.png", text_of(encode_png(image)));
        const Image read = load_texture((scratch / "noise.png").string());
        EXPECT_EQ(read.width, 37);
        EXPECT_EQ(read.height, 23);
        EXPECT_EQ(read.rgba, image.rgba) << "opaque " << opaque;
    }
}

TEST(Texture, ReadsJpeg) {
    const ScratchDirectory scratch;
    const std::vector<std::uint8_t> rgb(3 * 16 * 8, 0x60);
    ASSERT_NE(stbi_write_jpg((scratch / "grey.jpg").c_str(), 16, 8, 3, rgb.data(), 95), 0);
    const Image image = load_texture((scratch / "grey.jpg").string());
    EXPECT_EQ(image.width, 16);
    EXPECT_EQ(image.height, 8);
    EXPECT_NEAR(pixel_at(image, 7, 3)[1], 0x60, 2);
}

TEST(Texture, MissingFileIsAFileErrorThatListsTheBuiltInOnes) {
    const Error error = error_of("/nowhere/flagg.png");
    EXPECT_EQ(error.kind(), ErrorKind::file);
    EXPECT_STREQ(error.what(),
                 "/nowhere/flagg.png: the texture cannot be read: No such file or directory");
    EXPECT_NE(error.detail().find("flag, checker, stripes, linen, plain"), std::string::npos);
}

TEST(Texture, FolderIsAFileError) {
    const ScratchDirectory scratch;
    const Error error = error_of(scratch.path().string());
    EXPECT_EQ(error.kind(), ErrorKind::file);
    EXPECT_NE(error.message().find("Is a directory"), std::string::npos) << error.what();
}

TEST(Texture, OtherContentIsAFileError) {
    const ScratchDirectory scratch;
    const std::string file = (scratch / "picture.png").string();
    for (const std::string_view content : {"", "version = 1\n", "GIF89a\x01\x00\x01\x00"}) {
        test::write_text(file, content);
        const Error error = error_of(file);
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_EQ(error.message(), "the texture is no PNG or JPEG picture");
        EXPECT_EQ(error.place().file, file);
    }
}

TEST(Texture, CutOffOrDamagedPictureIsAFileError) {
    const ScratchDirectory scratch;
    const std::string file = (scratch / "picture.png").string();
    const std::string whole = text_of(encode_png(noise_image(64, 64, true)));
    for (const std::size_t length : {std::size_t{8}, std::size_t{20}, whole.size() / 2}) {
        test::write_text(file, std::string_view(whole).substr(0, length));
        const Error error = error_of(file);
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_TRUE(error.message().starts_with("the texture cannot be decoded: ")) << error.what();
    }
}

TEST(Texture, TooLargePictureIsRefusedBeforeItIsDecoded) {
    const ScratchDirectory scratch;
    const std::string file = (scratch / "wide.png").string();
    test::write_text(file, text_of(encode_png(noise_image(16385, 1, true))));
    EXPECT_EQ(error_of(file).message(), "the texture is 16385 x 1 pixels; at most 16384 x 16384");
}

}  // namespace
}  // namespace weft
