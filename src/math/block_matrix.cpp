#include "math/block_matrix.h"

#include <algorithm>

namespace weft {

BlockPattern::BlockPattern(std::size_t rows, std::size_t columns,
                           std::span<const Coupling> couplings)
    : rows_(rows) {
    const std::size_t readable = (columns + block_lanes - 1) / block_lanes * block_lanes;
    const std::size_t slices = (rows + block_lanes - 1) / block_lanes;
    std::vector<std::uint32_t> counts(slices * block_lanes, 0);
    for (const Coupling& c : couplings) ++counts[c.row];
    starts_.assign(slices + 1, 0);
    for (std::size_t s = 0; s < slices; ++s) {
        const auto first = counts.begin() + static_cast<std::ptrdiff_t>(s * block_lanes);
        starts_[s + 1] = starts_[s] + *std::max_element(first, first + block_lanes);
    }
    columns_ = LineAligned<std::uint32_t>(block_lanes * vectors());
    for (std::size_t s = 0; s < slices; ++s) {
        for (std::size_t n = block_lanes * starts_[s]; n < block_lanes * starts_[s + 1]; ++n) {
            const std::size_t own = s * block_lanes + n % block_lanes;
            columns_[n] = static_cast<std::uint32_t>(own < readable ? 4 * own : 0);
        }
    }
    std::fill(counts.begin(), counts.end(), 0);
    places_.reserve(couplings.size());
    for (const Coupling& c : couplings) {
        const std::size_t vector = starts_[c.row / block_lanes] + counts[c.row]++;
        places_.push_back(static_cast<std::uint32_t>(vector * block_lanes + c.row % block_lanes));
        columns_[places_.back()] = 4 * c.column;
    }
}

BlockMatrix::BlockMatrix(const BlockPattern& its_pattern, BlockForm its_form)
    : pattern(&its_pattern),
      form(its_form),
      couplings(static_cast<std::size_t>(its_form) * block_lanes * its_pattern.vectors()),
      own(6 * block_lanes * its_pattern.slices()),
      factors(6 * block_lanes * its_pattern.slices()) {}

namespace {

// Where number 0 of a block stands, of `numbers` each; the next stand block_lanes further.
std::size_t first_number(std::size_t place, std::size_t numbers) {
    return place / block_lanes * numbers * block_lanes + place % block_lanes;
}

SymmetricBlock block_at(const float* at) {
    constexpr std::size_t next = block_lanes;
    return {at[0], at[next], at[2 * next], at[3 * next], at[4 * next], at[5 * next]};
}

void set_block(float* at, const SymmetricBlock& block) {
    const double numbers[] = {block.xx, block.xy, block.xz, block.yy, block.yz, block.zz};
    for (std::size_t n = 0; n < 6; ++n) at[n * block_lanes] = static_cast<float>(numbers[n]);
}

}  // namespace

SymmetricBlock BlockMatrix::coupling(std::size_t place) const {
    const float* const at = couplings.data() + first_number(place, static_cast<std::size_t>(form));
    if (form == BlockForm::symmetric) return block_at(at);
    const double a = at[0], x = at[block_lanes], y = at[2 * block_lanes], z = at[3 * block_lanes];
    return {a + x * x, x * y, x * z, a + y * y, y * z, a + z * z};
}

SymmetricBlock BlockMatrix::own_block(std::size_t row) const {
    return block_at(own.data() + first_number(row, 6));
}

void BlockMatrix::set_coupling(std::size_t place, const SymmetricBlock& k) {
    set_block(couplings.data() + first_number(place, 6), k);
}

void BlockMatrix::set_spring(std::size_t place, double a, Vec3d g) {
    float* const at = couplings.data() + first_number(place, 4);
    const double numbers[] = {a, g.x, g.y, g.z};
    for (std::size_t n = 0; n < 4; ++n) at[n * block_lanes] = static_cast<float>(numbers[n]);
}

void BlockMatrix::set_own(std::size_t row, const SymmetricBlock& b) {
    set_block(own.data() + first_number(row, 6), b);
}

void BlockVector::fill_zero() {
    std::fill_n(values.data(), values.size(), 0.0f);
    std::fill_n(records.data(), records.size(), 0.0f);
}

}  // namespace weft
