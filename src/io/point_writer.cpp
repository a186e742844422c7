#include "io/point_writer.h"

#include <algorithm>

namespace weft {

namespace {

// Points that are turned into bytes and written together: what stays in the first-level caches.
constexpr std::size_t block_points = 2048;

static_assert(sizeof(Vec3f) == 12);

template <std::endian order, typename Real>
void put_points(std::span<const Vec3<Real>> points, std::byte* bytes) {
    for (const Vec3<Real>& point : points) {
        put<order>(bytes, static_cast<float>(point.x));
        put<order>(bytes + 4, static_cast<float>(point.y));
        put<order>(bytes + 8, static_cast<float>(point.z));
        bytes += 12;
    }
}

}  // namespace

void PointWriter::write_positions(OutputFile& file, const Frame& frame) {
    if (frame.rounded_positions.empty()) {
        write(file, frame.positions);
    } else {
        write(file, frame.rounded_positions);
    }
}

void PointWriter::write(OutputFile& file, std::span<const Vec3d> points) {
    write_in_blocks(file, points);
}

void PointWriter::write(OutputFile& file, std::span<const Vec3f> points) {
    if (order_ == std::endian::native) {
        file.write(std::as_bytes(points));
    } else {
        write_in_blocks(file, points);
    }
}

template <typename Real>
void PointWriter::write_in_blocks(OutputFile& file, std::span<const Vec3<Real>> points) {
    block_.resize(12 * std::min(points.size(), block_points));
    while (!points.empty()) {
        const auto part = points.first(std::min(points.size(), block_points));
        if (order_ == std::endian::little) {
            put_points<std::endian::little>(part, block_.data());
        } else {
            put_points<std::endian::big>(part, block_.data());
        }
        file.write(std::span(block_).first(12 * part.size()));
        points = points.subspan(part.size());
    }
}

}  // namespace weft
