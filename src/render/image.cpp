// Pictures from PNG and JPEG files and into PNG files; the work is done by stb.
#include "render/image.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "render/built_in_textures.h"
#include "weft/error.h"

namespace weft {

namespace {

constexpr int largest_side = 16384;  // [pixels]; what OpenGL drivers take
constexpr std::size_t largest_file = std::size_t{1} << 30;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string built_in_names() {
    std::string names;
    for (const TextureInfo& info : texture_catalogue()) {
        names += (names.empty() ? "" : ", ") + std::string(info.name);
    }
    return names;
}

std::vector<std::uint8_t> read_bytes(const std::string& path) {
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) {
        throw file_error(path, std::string("the texture cannot be read: ") + std::strerror(errno),
                         "A texture is a PNG or JPEG file or one of: " + built_in_names());
    }
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint8_t> block(std::size_t{1} << 16);
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
        bytes.insert(bytes.end(), block.begin(),
                     block.begin() + static_cast<std::ptrdiff_t>(count));
        if (bytes.size() > largest_file) {
            throw file_error(path, "the texture is larger than 1 GiB");
        }
    }
    if (std::ferror(file.get()) != 0) {
        throw file_error(path, std::string("the texture cannot be read: ") + std::strerror(errno));
    }
    return bytes;
}

/// stb reads more formats than weft promises; the others are refused so that scenes stay portable.
bool is_png_or_jpeg(const std::vector<std::uint8_t>& bytes) {
    constexpr std::uint8_t png[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    constexpr std::uint8_t jpeg[] = {0xff, 0xd8, 0xff};
    const auto starts_with = [&bytes](std::span<const std::uint8_t> mark) {
        return bytes.size() >= mark.size() && std::equal(mark.begin(), mark.end(), bytes.begin());
    };
    return starts_with(png) || starts_with(jpeg);
}

Image read_image(const std::string& path) {
    const std::vector<std::uint8_t> bytes = read_bytes(path);
    if (!is_png_or_jpeg(bytes)) throw file_error(path, "the texture is no PNG or JPEG picture");
    const int size = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    const bool known = stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) != 0;
    if (known && (width > largest_side || height > largest_side)) {
        throw file_error(path, "the texture is " + std::to_string(width) + " x " +
                                   std::to_string(height) + " pixels; at most 16384 x 16384");
    }
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
    if (!pixels) {
        throw file_error(path,
                         std::string("the texture cannot be decoded: ") + stbi_failure_reason());
    }
    const std::size_t length =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
    return {width, height, {pixels.get(), pixels.get() + length}};
}

void append_bytes(void* context, void* data, int size) {
    auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
    const auto* first = static_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), first, first + size);
}

bool is_opaque(const Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        if (image.rgba[i] != 255) return false;
    }
    return true;
}

std::vector<std::uint8_t> without_alpha(const Image& image) {
    std::vector<std::uint8_t> rgb(image.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgb.size() / 3; ++i) {
        std::copy_n(&image.rgba[4 * i], 3, &rgb[3 * i]);
    }
    return rgb;
}

}  // namespace

Image load_texture(const std::string& texture) {
    for (const BuiltInTexture& built_in : built_in_textures()) {
        if (texture == built_in.info.name) return built_in.paint();
    }
    return read_image(texture);
}

std::vector<std::uint8_t> encode_png(const Image& image) {
    std::vector<std::uint8_t> bytes;
    // Opaque pictures go without alpha: a quarter less to compress, and every program shows them.
    const bool opaque = is_opaque(image);
    const std::vector<std::uint8_t> rgb =
        opaque ? without_alpha(image) : std::vector<std::uint8_t>{};
    const int channels = opaque ? 3 : 4;
    const std::uint8_t* data = opaque ? rgb.data() : image.rgba.data();
    if (stbi_write_png_to_func(append_bytes, &bytes, image.width, image.height, channels, data,
                               image.width * channels) == 0) {
        throw file_error("", "a picture of " + std::to_string(image.width) + " x " +
                                 std::to_string(image.height) + " pixels cannot be encoded as PNG");
    }
    return bytes;
}

}  // namespace weft
