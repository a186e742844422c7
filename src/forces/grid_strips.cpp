#include "forces/grid_strips.h"

#include <algorithm>

#include "math/parallel.h"

namespace weft {

namespace {

// The ends of strips cost two vectors a row more, and the last strip is partly beside the cloth.
constexpr std::size_t shortest_strip = 32;

}  // namespace

template <typename Real>
GridStripState<Real>::GridStripState(std::size_t columns, std::size_t rows, std::size_t stride,
                                     std::size_t lanes)
    : columns_(columns), rows_(rows), stride_(stride), lanes_(lanes) {
    strips_.length = (columns + lanes - 1) / lanes;
}

template <typename Real>
bool GridStripState<Real>::pays() const {
    return strips_.length >= shortest_strip;
}

// Calls copy(number, column) for one array's number of every column of row j.
template <typename Real>
template <typename Copy>
void GridStripState<Real>::for_columns(std::size_t array, std::size_t j, const Copy& copy) const {
    const std::size_t block = lines_ * lanes_;
    Real* number = strips_.blocks + j * strips_.row_size + array * lanes_;
    for (std::size_t begin = 0; begin < columns_; begin += strips_.length, ++number) {
        const std::size_t count = std::min(strips_.length, columns_ - begin);
        for (std::size_t n = 0; n < count; ++n) copy(number[n * block], begin + n);
    }
}

template <typename Real>
void GridStripState<Real>::close(std::size_t j) const {
    const std::size_t beyond = strips_.length * lines_ * lanes_;
    Real* const first = strips_.blocks + j * strips_.row_size;
    for (std::size_t line = 0; line < GridStrips<Real>::blocks_beyond * lines_; ++line) {
        std::copy_n(first + line * lanes_ + 1, lanes_ - 1, first + beyond + line * lanes_);
    }
}

template <typename Real>
void GridStripState<Real>::take(ConstVec3View<Real> x, ConstVec3View<Real> v,
                                const Real* inverse_masses, ConstVec3View<Real> a) {
    using Strips = GridStrips<Real>;
    lines_ = Strips::lines_of(a.size > 0 ? GridUpdate::verlet : GridUpdate::kick_drift);
    strips_.row_size = Strips::size_of_row(strips_.length, lines_ * lanes_);
    const std::size_t size = rows_ * strips_.row_size;
    if (blocks_.size() != size) blocks_ = LineAligned<Real>(size);
    strips_.blocks = blocks_.data();
    const std::array<const Real*, 10> arrays{x.x, x.y, x.z, v.x, v.y, v.z, inverse_masses,
                                             a.x, a.y, a.z};
    parallel_for(rows_, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) {
            for (std::size_t n = 0; n < lines_; ++n) {
                for_columns(n, j, [row = arrays[n] + j * stride_](Real& number, std::size_t i) {
                    number = row[i];
                });
            }
            close(j);
        }
    });
}

template <typename Real>
void GridStripState<Real>::give(Vec3View<Real> x, Vec3View<Real> v, Vec3View<Real> a) {
    const std::array<Real*, 10> arrays{x.x, x.y, x.z, v.x, v.y, v.z, nullptr, a.x, a.y, a.z};
    parallel_for(rows_, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) {
            for (std::size_t n = 0; n < lines_; ++n) {
                if (arrays[n] == nullptr) continue;  // masses
                for_columns(n, j, [row = arrays[n] + j * stride_](Real number, std::size_t i) {
                    row[i] = number;
                });
            }
        }
    });
    strips_.blocks = nullptr;
}

template <typename Real>
void GridStripState<Real>::put(std::size_t slot, Vec3<Real> x, Vec3<Real> v) const {
    const std::size_t j = slot / stride_, column = slot % stride_;
    const std::size_t vector = column % strips_.length, lane = column / strips_.length;
    Real* const place = strips_.blocks + j * strips_.row_size + vector * lines_ * lanes_ + lane;
    const std::array<Real, 6> values{x.x, x.y, x.z, v.x, v.y, v.z};
    for (std::size_t n = 0; n < values.size(); ++n) place[n * lanes_] = values[n];
    if (vector < GridStrips<Real>::blocks_beyond) close(j);
}

template <typename Real>
std::vector<Real> GridStripState<Real>::in_strips(std::span<const Real> factors) const {
    std::vector<Real> ordered(strips_.length * lanes_, Real{0});
    for (std::size_t column = 0; column < columns_; ++column) {
        ordered[column % strips_.length * lanes_ + column / strips_.length] = factors[column];
    }
    return ordered;
}

template class GridStripState<float>;
template class GridStripState<double>;

}  // namespace weft
