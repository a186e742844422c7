// Where particles stand in the arrays of a state. Users number particles as the scene does; kernels
// want rows of a grid on cache lines, and neighbours of a mesh near each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace weft {

/// Maps particles to slots, the places of a state's arrays. A slot of no particle is padding: it
/// stays zero. A default layout has no particles.
class ParticleLayout {
public:
    ParticleLayout() = default;

    /// Particle (column i, row j), numbered row by row, stands at slot j * row_stride() + i. Rows
    /// begin on cache lines, and never a whole number of pages apart: rows above each other would
    /// share one set of the first-level cache.
    static ParticleLayout of_grid(std::size_t columns, std::size_t rows) {
        constexpr std::size_t line = 16;   // floats in a cache line; doubles fill two
        constexpr std::size_t page = 512;  // doubles in 4 KiB; floats fill half
        ParticleLayout layout;
        layout.columns_ = columns;
        layout.rows_ = rows;
        layout.stride_ = (columns + line - 1) / line * line;
        if (layout.stride_ % page == 0) layout.stride_ += line;
        return layout;
    }

    /// Particle p stands at slot slots[p], each slot taken once.
    static ParticleLayout of_slots(std::vector<std::uint32_t> slots) {
        ParticleLayout layout;
        layout.columns_ = layout.stride_ = slots.size();
        layout.rows_ = 1;
        layout.slots_ = std::move(slots);
        return layout;
    }

    /// Every particle at its own number.
    static ParticleLayout in_order(std::size_t particle_count) {
        std::vector<std::uint32_t> slots(particle_count);
        std::iota(slots.begin(), slots.end(), 0u);
        return of_slots(std::move(slots));
    }

    [[nodiscard]] std::size_t particle_count() const { return columns_ * rows_; }
    [[nodiscard]] std::size_t slot_count() const { return stride_ * rows_; }
    [[nodiscard]] std::size_t row_stride() const { return stride_; }

    [[nodiscard]] std::size_t slot(std::size_t particle) const {
        if (!slots_.empty()) return slots_[particle];
        return particle / columns_ * stride_ + particle % columns_;
    }

    /// Calls visit(particle, slot) for all particles in rising order.
    template <typename Visit>
    void for_each(const Visit& visit) const {
        for (std::size_t p = 0; p < slots_.size(); ++p) visit(p, std::size_t{slots_[p]});
        if (!slots_.empty()) return;
        for (std::size_t j = 0; j < rows_; ++j) {
            for (std::size_t i = 0; i < columns_; ++i) visit(j * columns_ + i, j * stride_ + i);
        }
    }

private:
    std::size_t columns_ = 0, rows_ = 0, stride_ = 0;
    std::vector<std::uint32_t> slots_;  // [particle]; empty on a grid
};

}  // namespace weft
