// Pictures in memory, textures among them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace weft {

/// Rows from the top, 8 bits a channel, sRGB.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;  ///< [height][width][4]
};

/// A built-in texture: a row of the table that the scene key render.texture reads.
struct TextureInfo {
    std::string_view name;  ///< "flag"
    std::string_view description;
};
std::span<const TextureInfo> texture_catalogue();

/// The picture of a texture: a built-in one by name, else a PNG or JPEG file.
/// @throws Error (file) where the file cannot be read or is no picture.
Image load_texture(const std::string& texture);

/// @return a PNG file's bytes.
std::vector<std::uint8_t> encode_png(const Image& image);

}  // namespace weft
