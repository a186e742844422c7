// The tables of one level's passage to the next coarser one (NewtonTransfer), and where the coarser
// nodes stand.
#pragma once

#include <vector>

#include "forces/newton_pass.h"

namespace weft {

class MultigridTransferAxis {
public:
    /// @param coarse fine, or less: at least 2 and 2/5 of it.
    MultigridTransferAxis(std::size_t fine, std::size_t coarse);

    /// Points into this object.
    [[nodiscard]] NewtonTransferAxis tables() const;

    /// A coarse node stands between fine nodes `left` and left + 1.
    struct Sample {
        std::size_t left = 0;
        float weight = 0;  ///< of left + 1
    };
    [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

private:
    void set_taken();

    std::size_t fine_, coarse_;
    std::vector<std::int32_t> left_, first_;
    std::vector<float> weight_;
    std::array<std::vector<float>, NewtonTransferAxis::taps> taken_;
    std::vector<Sample> samples_;  // [coarse]
};

class MultigridTransfer {
public:
    /// @param fine, coarse the levels' layouts: columns and rows, and their row strides.
    MultigridTransfer(std::size_t fine_columns, std::size_t fine_rows, std::size_t fine_stride,
                      std::size_t coarse_columns, std::size_t coarse_rows,
                      std::size_t coarse_stride);

    [[nodiscard]] NewtonTransfer tables() const;

    /// Samples a field of the finer level at the coarser level's nodes, on coarse rows [begin,
    /// end).
    void sample(const float* fine, float* coarse, std::size_t begin, std::size_t end) const;

private:
    MultigridTransferAxis across_, down_;
    std::size_t fine_stride_, coarse_stride_;
};

}  // namespace weft
