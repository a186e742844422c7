// The table of built-in textures, and the simple ones.
#include "render/built_in_textures.h"

#include <array>
#include <cmath>
#include <numbers>

#include "render/painting.h"

namespace weft {

namespace {

constexpr std::array<BuiltInTexture, 5> table{{
    {{"flag", "indigo, a coral fly and a woven knot; the flag of weft"}, paint_flag},
    {{"checker", "8 x 8 squares, for judging stretch and shear"}, paint_checker},
    {{"stripes", "upright stripes of a market awning"}, paint_stripes},
    {{"linen", "undyed cloth of crossing threads"}, paint_linen},
    {{"plain", "one warm colour, for judging folds"}, paint_plain},
}};

/// A number in [0, 1) that depends on `key` alone (integer hash, bits well mixed).
float random_unit(std::uint32_t key) {
    key = (key ^ (key >> 16)) * 0x7feb352dU;
    key = (key ^ (key >> 15)) * 0x846ca68bU;
    key ^= key >> 16;
    return static_cast<float>(key >> 8) / 16777216.0F;
}

}  // namespace

std::span<const BuiltInTexture> built_in_textures() {
    return table;
}

std::span<const TextureInfo> texture_catalogue() {
    static const auto infos = [] {
        std::array<TextureInfo, table.size()> rows;
        for (std::size_t i = 0; i < table.size(); ++i) rows[i] = table[i].info;
        return rows;
    }();
    return infos;
}

Image paint_checker() {
    constexpr Paint light{236, 231, 220}, dark{54, 98, 122};
    return paint_image(1024, 1024, [=](float x, float y) {
        const int square = static_cast<int>(x / 128.0F) + static_cast<int>(y / 128.0F);
        return square % 2 == 0 ? light : dark;
    });
}

Image paint_stripes() {
    constexpr Paint light{240, 233, 218}, dark{176, 58, 52};
    return paint_image(1024, 1024, [=](float x, float) {
        const float phase = x / 1024.0F * 5.0F;  // pairs of stripes
        const float distance = std::abs(phase - std::floor(phase) - 0.5F) - 0.25F;
        return glm::mix(light, dark, coverage(distance, 5.0F / 1024.0F));
    });
}

Image paint_linen() {
    constexpr float pitch = 8.0F;  // [pixels] from thread to thread
    constexpr Paint tone{226, 214, 190};
    return paint_image(1024, 1024, [=](float x, float y) {
        const auto column = static_cast<std::uint32_t>(x / pitch);
        const auto row = static_cast<std::uint32_t>(y / pitch);
        const bool upright_on_top = (column + row) % 2 == 0;
        const float across = (upright_on_top ? x : y) / pitch;
        const float along = (upright_on_top ? y : x) / pitch;
        const float round = std::sin(std::numbers::pi_v<float> * (across - std::floor(across)));
        const float bow = std::sin(std::numbers::pi_v<float> * (along - std::floor(along)));
        // Threads differ in shade over their whole length: that is what makes linen look spun.
        const float shade = random_unit(upright_on_top ? column : 0x10000U + row);
        return tone * (0.72F + 0.22F * round * (0.55F + 0.45F * bow) + 0.06F * shade);
    });
}

Image paint_plain() {
    return paint_image(16, 16, [](float, float) { return Paint{201, 92, 74}; });
}

}  // namespace weft
