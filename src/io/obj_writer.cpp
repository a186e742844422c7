// Wavefront OBJ text: v, vt, vn and f lines; indices count from 1.
#include "io/obj_writer.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>

namespace weft {

namespace {

/// Text goes to the file in blocks of about this many characters.
constexpr std::size_t block_size = std::size_t{1} << 16;

void append_corner(fmt::memory_buffer& text, const Surface& surface, std::uint32_t vertex,
                   bool with_normals) {
    const std::uint32_t particle = surface.particle(vertex) + 1;
    fmt::format_to(std::back_inserter(text), FMT_COMPILE(" {}/{}"), particle, vertex + 1);
    if (with_normals) fmt::format_to(std::back_inserter(text), FMT_COMPILE("/{}"), particle);
}

}  // namespace

void write_obj(OutputFile& file, std::string_view comment, const Surface& surface,
               std::span<const Vec3d> positions, std::span<const Vec3f> normals) {
    fmt::memory_buffer text;
    const auto flush = [&](std::size_t limit) {
        if (text.size() <= limit) return;
        file.write(std::string_view(text.data(), text.size()));
        text.clear();
    };
    text.append(comment);
    // {} prints the shortest digits that read back to the same float.
    for (const Vec3d& position : positions) {
        const auto p = vec3_cast<float>(position);
        fmt::format_to(std::back_inserter(text), FMT_COMPILE("v {} {} {}\n"), p.x, p.y, p.z);
        flush(block_size);
    }
    for (const auto& uv : surface.uvs) {
        fmt::format_to(std::back_inserter(text), FMT_COMPILE("vt {} {}\n"), uv[0], uv[1]);
        flush(block_size);
    }
    for (const Vec3f& n : normals) {
        fmt::format_to(std::back_inserter(text), FMT_COMPILE("vn {} {} {}\n"), n.x, n.y, n.z);
        flush(block_size);
    }
    for (const auto& face : surface.faces) {
        text.push_back('f');
        for (const std::uint32_t vertex : face)
            if (vertex != Surface::no_vertex)
                append_corner(text, surface, vertex, !normals.empty());
        text.push_back('\n');
        flush(block_size);
    }
    flush(0);
}

}  // namespace weft
