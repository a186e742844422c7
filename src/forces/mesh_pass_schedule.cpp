#include "forces/mesh_pass_schedule.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace weft {

namespace {

// From the lowest to behind the highest of some numbers.
struct Range {
    std::size_t begin, end;

    void include(std::span<const std::uint32_t> numbers) {
        for (const std::size_t n : numbers) {
            if (n == MeshTriangleTables::none) continue;
            begin = std::min(begin, n);
            end = std::max(end, n + 1);
        }
    }
};

// Items of the vectors [begin, end).
std::span<const std::uint32_t> vectors_of(const LineAligned<std::uint32_t>& items,
                                          std::size_t begin, std::size_t end, std::size_t lanes) {
    return {items.data() + begin * lanes, (end - begin) * lanes};
}

}  // namespace

MeshSchedule::MeshSchedule(const SlicedLists& neighbours, const MeshTriangleTables& triangles,
                           std::size_t slices, std::size_t slices_per_chunk, std::size_t lanes) {
    const bool air = !triangles.triangles.starts.empty();
    MeshChunk done;
    while (done.slices_moved < slices) {
        const std::size_t begin = done.slices_moved;
        const std::size_t end = std::min(begin + slices_per_chunk, slices);
        Range slots{begin * lanes, end * lanes};
        slots.include(vectors_of(neighbours.items, neighbours.starts[spring_kind_count * begin],
                                 neighbours.starts[spring_kind_count * end], lanes));
        if (air) {
            const std::vector<std::uint32_t>& starts = triangles.triangles.starts;
            const std::size_t found = done.triangle_vectors;
            Range numbers{found * lanes, found * lanes};
            numbers.include(
                vectors_of(triangles.triangles.items, starts[begin], starts[end], lanes));
            done.triangle_vectors = (numbers.end + lanes - 1) / lanes;
            slots.include(
                vectors_of(triangles.corners, 3 * found, 3 * done.triangle_vectors, lanes));
            thirds = std::max(thirds, done.triangle_vectors * lanes - numbers.begin);
        }
        done.slices_copied = std::max(done.slices_copied, (slots.end + lanes - 1) / lanes);
        done.slices_moved = end;
        rows = std::max(rows, done.slices_copied * lanes - slots.begin / lanes * lanes);
        chunks.push_back(done);
    }
    rows = std::bit_ceil(rows);
    if (thirds > 0) thirds = std::bit_ceil(thirds);
}

}  // namespace weft
