// NumPy files: the head, which says what the numbers behind it are, and vectors behind it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/byte_order.h"
#include "io/input_file.h"
#include "io/output_file.h"
#include "weft/vec3.h"

namespace weft {

struct NpyHead {
    std::string element;               ///< "<f8": little-endian, floating-point, 8 bytes
    bool fortran_order = false;        ///< the first index runs fastest, else the last
    std::vector<std::uint64_t> shape;  ///< counts of each index, the outermost first
    std::uint64_t size = 0;            ///< where the numbers begin [bytes]
};

/// A head of format 1.0, of 128 bytes whatever the shape.
/// @param shape as Python writes a tuple, without the parentheses: "2, 1600, 3".
Bytes npy_head(std::string_view element, std::string_view shape);

/// Vectors as elements "<f8".  @throws Error (file).
void write_npy_vectors(OutputFile& file, std::span<const Vec3d> vectors);

/// Reads a head of format 1.0, 2.0 or 3.0.
/// @throws Error (file) where there is none, or where it says something twice, not or otherwise.
NpyHead read_npy_head(const InputFile& file);

}  // namespace weft
