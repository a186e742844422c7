#include "forces/grid_multigrid_transfer.h"

#include <algorithm>
#include <cmath>

namespace weft {

namespace {

// Floats in a cache line: kernels read tables in whole vectors.
constexpr std::size_t line = 16;

std::size_t whole_lines(std::size_t count) {
    return (count + line - 1) / line * line;
}

// Co-ordinate of node n of `from`, measured in distances of `to`: exact where it is a node of both.
double coordinate(std::size_t n, std::size_t from, std::size_t to) {
    return static_cast<double>(n * (to - 1)) / static_cast<double>(from - 1);
}

// The node to the left of a co-ordinate and how far beyond it that is; of the last node: itself.
std::pair<std::size_t, double> split(double coordinate) {
    const double left = std::floor(coordinate);
    return {static_cast<std::size_t>(left), coordinate - left};
}

}  // namespace

MultigridTransferAxis::MultigridTransferAxis(std::size_t fine, std::size_t coarse)
    : fine_(fine), coarse_(coarse) {
    left_.assign(whole_lines(fine), 0);
    weight_.assign(whole_lines(fine), 0.0f);
    for (std::size_t i = 0; i < fine; ++i) {
        const auto [left, weight] = split(coordinate(i, fine, coarse));
        left_[i] = static_cast<std::int32_t>(left);
        weight_[i] = static_cast<float>(weight);
    }
    for (std::size_t c = 0; c < coarse; ++c) {
        const auto [left, weight] = split(coordinate(c, coarse, fine));
        samples_.push_back({left, static_cast<float>(weight)});
    }
    set_taken();
}

// The transpose of interpolation: node i counts 1 - weight at `left`, and weight at left + 1.
void MultigridTransferAxis::set_taken() {
    first_.assign(whole_lines(coarse_), 0);
    for (std::vector<float>& taken : taken_) taken.assign(whole_lines(coarse_), 0.0f);
    std::vector<bool> begun(coarse_, false);
    const auto take = [&](std::size_t c, std::size_t i, float weight) {
        if (weight == 0.0f) return;
        if (!begun[c]) first_[c] = static_cast<std::int32_t>(i);
        begun[c] = true;
        taken_[i - static_cast<std::size_t>(first_[c])][c] = weight;
    };
    for (std::size_t i = 0; i < fine_; ++i) {
        const auto left = static_cast<std::size_t>(left_[i]);
        take(left, i, 1 - weight_[i]);
        take(left + 1, i, weight_[i]);
    }
}

NewtonTransferAxis MultigridTransferAxis::tables() const {
    NewtonTransferAxis axis{fine_, coarse_, left_.data(), weight_.data(), first_.data(), {}};
    for (std::size_t n = 0; n < taken_.size(); ++n) axis.taken[n] = taken_[n].data();
    return axis;
}

MultigridTransfer::MultigridTransfer(std::size_t fine_columns, std::size_t fine_rows,
                                     std::size_t fine_stride, std::size_t coarse_columns,
                                     std::size_t coarse_rows, std::size_t coarse_stride)
    : across_(fine_columns, coarse_columns),
      down_(fine_rows, coarse_rows),
      fine_stride_(fine_stride),
      coarse_stride_(coarse_stride) {}

NewtonTransfer MultigridTransfer::tables() const {
    return {across_.tables(), down_.tables(), fine_stride_, coarse_stride_};
}

void MultigridTransfer::sample(const float* fine, float* coarse, std::size_t begin,
                               std::size_t end) const {
    for (std::size_t j = begin; j < end; ++j) {
        const MultigridTransferAxis::Sample row = down_.samples()[j];
        const float* const above = fine + row.left * fine_stride_;
        const float* const below = row.weight > 0 ? above + fine_stride_ : above;
        float* const out = coarse + j * coarse_stride_;
        for (std::size_t i = 0; i < across_.samples().size(); ++i) {
            const auto [left, weight] = across_.samples()[i];
            // Behind the last node stands padding, of weight 0.
            const float a = above[left] + weight * (above[left + 1] - above[left]);
            const float b = below[left] + weight * (below[left + 1] - below[left]);
            out[i] = a + row.weight * (b - a);
        }
    }
}

}  // namespace weft
