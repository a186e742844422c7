#include "lab/look/picture_text.h"

#include <stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace weft::lab {

namespace {

// A corner of a quad as stb_easy_font writes it.
struct Corner {
    float x, y, z;
    std::array<std::uint8_t, 4> colour;
};
constexpr std::size_t bytes_per_letter = 1000;  // it uses 270 on average

}  // namespace

Image blank_image(int width, int height, Colour colour) {
    Image image{width, height, {}};
    image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
    fill_rectangle(image, 0, 0, width, height, colour);
    return image;
}

void fill_rectangle(Image& image, int x, int y, int width, int height, Colour colour) {
    const int left = std::max(x, 0), right = std::min(x + width, image.width);
    const int top = std::max(y, 0), bottom = std::min(y + height, image.height);
    for (int row = top; row < bottom; ++row) {
        for (int column = left; column < right; ++column) {
            std::uint8_t* const pixel =
                image.rgba.data() +
                4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(column));
            pixel[0] = colour.red;
            pixel[1] = colour.green;
            pixel[2] = colour.blue;
        }
    }
}

void paste(Image& image, const Image& part, int x, int y) {
    const int left = std::max(x, 0), right = std::min(x + part.width, image.width);
    if (left >= right) return;
    for (int row = std::max(y, 0); row < std::min(y + part.height, image.height); ++row) {
        const auto place = [](const Image& in, int column, int line) {
            return 4 * (static_cast<std::size_t>(line) * static_cast<std::size_t>(in.width) +
                        static_cast<std::size_t>(column));
        };
        std::memcpy(image.rgba.data() + place(image, left, row),
                    part.rgba.data() + place(part, left - x, row - y),
                    4 * static_cast<std::size_t>(right - left));
    }
}

void draw_border(Image& image, int thickness, Colour colour) {
    fill_rectangle(image, 0, 0, image.width, thickness, colour);
    fill_rectangle(image, 0, image.height - thickness, image.width, thickness, colour);
    fill_rectangle(image, 0, 0, thickness, image.height, colour);
    fill_rectangle(image, image.width - thickness, 0, thickness, image.height, colour);
}

void draw_text(Image& image, int x, int y, std::string_view text, Colour colour, int scale) {
    std::string line(text);  // stb takes what it may write to, with a zero at its end
    std::vector<Corner> corners((line.size() + 1) * bytes_per_letter / sizeof(Corner));
    const int quads = stb_easy_font_print(0.0F, 0.0F, line.data(), nullptr, corners.data(),
                                          static_cast<int>(corners.size() * sizeof(Corner)));
    for (int q = 0; q < quads; ++q) {
        const Corner &from = corners[4 * static_cast<std::size_t>(q)],
                     &to = corners[4 * static_cast<std::size_t>(q) + 2];
        const auto pixels = [scale](float units) {
            return static_cast<int>(std::lround(units * static_cast<float>(scale)));
        };
        fill_rectangle(image, x + pixels(from.x), y + pixels(from.y), pixels(to.x - from.x),
                       pixels(to.y - from.y), colour);
    }
}

int text_width(std::string_view text, int scale) {
    std::string line(text);
    return scale * stb_easy_font_width(line.data());
}

int text_height(int scale) {
    return 12 * scale;
}

}  // namespace weft::lab
