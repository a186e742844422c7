#include "io/start_state_file.h"

#include <fmt/format.h>

#include "io/byte_order.h"
#include "io/input_file.h"
#include "io/npy_format.h"

namespace weft {

namespace {

/// The particles of a head that is as it should be.
std::uint64_t checked_particles(const NpyHead& head, const InputFile& file) {
    if (head.element != "<f8" && head.element != "<f4") {
        throw file.error(fmt::format(
            "has elements of type \"{}\"; \"<f8\" or \"<f4\" (float64, float32) is needed",
            head.element));
    }
    if (head.fortran_order) throw file.error("is in Fortran order; C order is needed");
    if (head.shape.size() != 3 || head.shape[0] != 2 || head.shape[1] == 0 || head.shape[2] != 3) {
        throw file.error(fmt::format(
            "has the shape ({}); (2, particles, 3) is needed: positions, then velocities",
            fmt::join(head.shape, ", ")));
    }
    return head.shape[1];
}

template <typename Number>
std::vector<Vec3d> vectors_of(std::span<const std::byte> bytes) {
    constexpr std::size_t size = sizeof(Number);
    std::vector<Vec3d> vectors(bytes.size() / (3 * size));
    const auto number = [&](std::size_t n) {
        return static_cast<double>(number_at<std::endian::little, Number>(bytes, n * size));
    };
    for (std::size_t p = 0; p < vectors.size(); ++p) {
        vectors[p] = {number(3 * p), number(3 * p + 1), number(3 * p + 2)};
    }
    return vectors;
}

void require_finite(std::span<const Vec3d> vectors, std::string_view what, const InputFile& file) {
    for (std::size_t p = 0; p < vectors.size(); ++p) {
        if (is_finite(vectors[p])) continue;
        throw file.error(fmt::format("the {} of particle {} is not finite", what, p));
    }
}

}  // namespace

ClothState load_start_state(const std::filesystem::path& path) {
    const InputFile file(path);
    const NpyHead head = read_npy_head(file);
    const std::uint64_t particles = checked_particles(head, file);
    const std::uint64_t vector_size = head.element == "<f8" ? 24 : 12;
    const std::uint64_t there = file.size() - head.size;
    // Divided, as a product could overflow.
    if (there % (2 * vector_size) != 0 || there / (2 * vector_size) != particles) {
        throw file.error(
            fmt::format("has {} bytes behind its head; a state of {} particles has {} bytes each",
                        there, particles, 2 * vector_size));
    }
    const auto vectors = [&](std::uint64_t number) {
        const std::uint64_t size = particles * vector_size;
        const Bytes bytes = file.read(head.size + number * size, size);
        return vector_size == 24 ? vectors_of<double>(bytes) : vectors_of<float>(bytes);
    };
    ClothState state{vectors(0), vectors(1)};
    require_finite(state.positions, "position", file);
    require_finite(state.velocities, "velocity", file);
    return state;
}

void write_start_state(OutputFile& file, const ClothState& state) {
    file.write(npy_head("<f8", fmt::format("2, {}, 3", state.positions.size())));
    write_npy_vectors(file, state.positions);
    write_npy_vectors(file, state.velocities);
}

}  // namespace weft
