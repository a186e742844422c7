// Words in pictures, and pictures in pictures.
#pragma once

#include <string_view>

#include "render/image.h"

namespace weft::lab {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
};

/// An opaque picture of one colour.
Image blank_image(int width, int height, Colour colour);

/// Fills the rectangle from (x, y), as far as it is inside the picture.
void fill_rectangle(Image& image, int x, int y, int width, int height, Colour colour);

/// Puts `part` with its top left corner at (x, y), as far as it is inside the picture.
void paste(Image& image, const Image& part, int x, int y);

/// A frame of so many pixels along the inner border.
void draw_border(Image& image, int thickness, Colour colour);

/// Writes one line of ASCII with its top left corner at (x, y). Letters are about 7 pixels high and
/// 6 wide, times `scale`.
void draw_text(Image& image, int x, int y, std::string_view text, Colour colour, int scale = 1);
int text_width(std::string_view text, int scale = 1);
int text_height(int scale = 1);  ///< from one line to the next

}  // namespace weft::lab
