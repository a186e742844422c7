// The header of a PLY file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace weft {

enum class PlyFormat { ascii, little_endian, big_endian };

/// A number type of PLY, which has two names for each.
struct PlyType {
    std::string_view name, other_name;  ///< "uchar", "uint8"
    std::size_t size = 0;               ///< in a binary file [bytes]
    bool whole = false, is_signed = false;
};

struct PlyProperty {
    std::string name;
    const PlyType* type = nullptr;
    const PlyType* count_type = nullptr;  ///< null: not a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;  ///< where the body begins [bytes]
    int lines = 0;

    /// @return null where there is none.
    [[nodiscard]] const PlyElement* find(std::string_view element) const;
};

/// Reads the header. The elements vertex (x, y, z) and face (a list vertex_indices or vertex_index)
/// must be there, and every count must be possible in a file of this size.
/// @throws Error (file) with the line.
PlyHeader read_ply_header(std::string_view bytes, const std::string& file);

/// A header with the two elements that make a mesh, each property under the name that it is read
/// by.
std::string plain_ply_header(const PlyHeader& header);

}  // namespace weft
