// The textures that weft paints itself, so that every scene has one without any file.
#pragma once

#include <span>

#include "render/image.h"

namespace weft {

/// One built-in texture: its row in the catalogue and the function that paints it.
struct BuiltInTexture {
    TextureInfo info;
    Image (*paint)();
};
std::span<const BuiltInTexture> built_in_textures();

Image paint_flag();     ///< 1536 x 1024 pixels
Image paint_checker();  ///< 1024 x 1024 pixels, 8 x 8 squares
Image paint_stripes();  ///< 1024 x 1024 pixels, 10 upright stripes
Image paint_linen();    ///< 1024 x 1024 pixels, 128 x 128 threads
Image paint_plain();    ///< 16 x 16 pixels of one colour

}  // namespace weft
