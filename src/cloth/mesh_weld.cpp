#include "cloth/mesh_weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

namespace weft {

namespace {

constexpr double tolerance_over_diagonal = 1e-6;
// Cells wider than the tolerance: the ball around a vertex then mostly lies in one cell.
constexpr double cell_over_tolerance = 8.0;

std::vector<bool> vertices_in_faces(const Mesh& mesh) {
    std::vector<bool> used(mesh.positions.size(), false);
    for (const Mesh::Face& face : mesh.faces)
        for (std::size_t k = 0; k < static_cast<std::size_t>(face.corners); ++k)
            used[face.position[k]] = true;
    return used;
}

/// The particles so far, in cells of a grid over the box around them. A cell holds a chain of
/// particles; cells are found by open addressing.
class ParticleGrid {
public:
    ParticleGrid(std::span<const Vec3d> positions, const std::vector<bool>& used);

    /// @return the earliest particle within the tolerance of `at`, or MeshWeld::unused.
    [[nodiscard]] std::uint32_t find(Vec3d at) const;
    /// Adds the next particle.
    void add(Vec3d at);

private:
    using Cell = std::array<std::int64_t, 3>;

    struct Slot {
        std::uint64_t key = 0;                    // 0: empty
        std::uint32_t newest = MeshWeld::unused;  // head of the cell's chain
    };

    static std::uint64_t key_of(const Cell& cell);
    [[nodiscard]] Cell cell_at(Vec3d at, double shift) const;
    [[nodiscard]] std::size_t slot_of(std::uint64_t key) const;
    [[nodiscard]] std::uint32_t find_in_cell(const Cell& cell, Vec3d at) const;

    Vec3d low_{};
    double tolerance_ = 0.0, per_cell_ = 0.0;
    std::vector<Slot> slots_;
    std::vector<Vec3d> places_;         // [particle]
    std::vector<std::uint32_t> older_;  // [particle] next in its cell's chain
};

ParticleGrid::ParticleGrid(std::span<const Vec3d> positions, const std::vector<bool>& used) {
    constexpr double far = std::numeric_limits<double>::max();
    Vec3d low{far, far, far}, high{-far, -far, -far};
    std::size_t count = 0;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        if (!used[v]) continue;
        const Vec3d p = positions[v];
        low = {std::fmin(low.x, p.x), std::fmin(low.y, p.y), std::fmin(low.z, p.z)};
        high = {std::fmax(high.x, p.x), std::fmax(high.y, p.y), std::fmax(high.z, p.z)};
        ++count;
    }
    low_ = low;
    // A box without extent keeps a tolerance above zero: one cell then holds everything.
    tolerance_ = std::fmax(tolerance_over_diagonal * length(high - low), 1e-150);
    per_cell_ = 1.0 / (cell_over_tolerance * tolerance_);
    slots_.resize(std::bit_ceil(2 * count + 1));
}

ParticleGrid::Cell ParticleGrid::cell_at(Vec3d at, double shift) const {
    const auto index = [&](double x, double low) {
        return static_cast<std::int64_t>(std::floor((x - low + shift) * per_cell_)) + 1;
    };
    return {index(at.x, low_.x), index(at.y, low_.y), index(at.z, low_.z)};
}

std::uint64_t ParticleGrid::key_of(const Cell& cell) {
    // At most 1e6 / 8 + 3 cells along an axis, so 21 bits each never mix.
    return (static_cast<std::uint64_t>(cell[0]) << 42 | static_cast<std::uint64_t>(cell[1]) << 21 |
            static_cast<std::uint64_t>(cell[2])) +
           1;
}

std::size_t ParticleGrid::slot_of(std::uint64_t key) const {
    std::uint64_t hash = key * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
    std::size_t slot = hash & (slots_.size() - 1);
    while (slots_[slot].key != 0 && slots_[slot].key != key)
        slot = (slot + 1) & (slots_.size() - 1);
    return slot;
}

std::uint32_t ParticleGrid::find_in_cell(const Cell& cell, Vec3d at) const {
    std::uint32_t earliest = MeshWeld::unused;
    const Slot& slot = slots_[slot_of(key_of(cell))];
    for (std::uint32_t p = slot.newest; p != MeshWeld::unused; p = older_[p])
        if (length(places_[p] - at) <= tolerance_) earliest = p;  // the chain runs back in time
    return earliest;
}

std::uint32_t ParticleGrid::find(Vec3d at) const {
    const Cell from = cell_at(at, -tolerance_), to = cell_at(at, tolerance_);
    std::uint32_t earliest = MeshWeld::unused;
    for (std::int64_t i = from[0]; i <= to[0]; ++i)
        for (std::int64_t j = from[1]; j <= to[1]; ++j)
            for (std::int64_t k = from[2]; k <= to[2]; ++k)
                earliest = std::min(earliest, find_in_cell({i, j, k}, at));
    return earliest;
}

void ParticleGrid::add(Vec3d at) {
    const std::uint64_t key = key_of(cell_at(at, 0.0));
    Slot& slot = slots_[slot_of(key)];
    slot.key = key;
    older_.push_back(slot.newest);
    slot.newest = static_cast<std::uint32_t>(places_.size());
    places_.push_back(at);
}

}  // namespace

MeshWeld weld_vertices(const Mesh& mesh) {
    const std::vector<bool> used = vertices_in_faces(mesh);
    ParticleGrid grid(mesh.positions, used);
    MeshWeld weld;
    weld.vertex_particle.assign(mesh.positions.size(), MeshWeld::unused);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        if (!used[v]) {
            ++weld.unused_vertices;
            continue;
        }
        std::uint32_t particle = grid.find(mesh.positions[v]);
        if (particle == MeshWeld::unused) {
            particle = static_cast<std::uint32_t>(weld.first_vertex.size());
            weld.first_vertex.push_back(static_cast<std::uint32_t>(v));
            grid.add(mesh.positions[v]);
        } else {
            ++weld.welded_vertices;
        }
        weld.vertex_particle[v] = particle;
    }
    return weld;
}

}  // namespace weft
