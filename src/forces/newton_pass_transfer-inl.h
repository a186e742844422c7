// What passes between the levels of forces/newton_pass.h, and the vector operations of conjugate
// gradients, with the vectors of one instruction set; included once for each.
#if defined(WEFT_FORCES_NEWTON_PASS_TRANSFER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_NEWTON_PASS_TRANSFER_INL_H
#undef WEFT_FORCES_NEWTON_PASS_TRANSFER_INL_H
#else
#define WEFT_FORCES_NEWTON_PASS_TRANSFER_INL_H
#endif

#include <hwy/highway.h>

#include "forces/newton_pass.h"
#include "math/simd-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

using TransferTag = hn::ScalableTag<float>;

// out[c] = sum of weights times fine nodes of a row. `line` is zero before its first node and
// behind its last.
HWY_INLINE void coarsen_row(const NewtonTransferAxis& axis, const float* line, float* out) {
    const TransferTag d;
    const hn::RebindToSigned<TransferTag> di;
    const std::size_t lanes = hn::Lanes(d);
    if (axis.halves()) {
        const auto half = hn::Set(d, 0.5f);
        for (std::size_t c = 0; c < axis.coarse; c += lanes) {
            const auto a = hn::LoadU(d, line + 2 * c), b = hn::LoadU(d, line + 2 * c + lanes);
            const auto e = hn::LoadU(d, line + 2 * c - 1);
            const auto f = hn::LoadU(d, line + 2 * c + lanes - 1);
            const auto beside = hn::Add(hn::ConcatOdd(d, b, a), hn::ConcatEven(d, f, e));
            hn::StoreU(hn::MulAdd(half, beside, hn::ConcatEven(d, b, a)), d, out + c);
        }
        return;
    }
    for (std::size_t c = 0; c < axis.coarse; c += lanes) {
        const auto first = hn::LoadU(di, axis.first + c);
        auto sum = hn::Zero(d);
        for (std::size_t n = 0; n < NewtonTransferAxis::taps; ++n) {
            sum = hn::MulAdd(hn::LoadU(d, axis.taken[n] + c), hn::GatherIndex(d, line + n, first),
                             sum);
        }
        hn::StoreU(sum, d, out + c);
    }
}

HWY_NOINLINE void newton_coarsen(const NewtonTransfer& transfer, const NewtonBand& band,
                                 const float* fine, float* coarse) {
    const TransferTag d;
    float* const line = band.transfer_line(transfer.fine_stride);
    const NewtonTransferAxis& down = transfer.down;
    for (std::size_t j = band.row_begin; j < band.row_end; ++j) {
        const auto first = static_cast<std::size_t>(down.first[j]);
        const std::size_t count = down.fine - first < NewtonTransferAxis::taps
                                      ? down.fine - first
                                      : NewtonTransferAxis::taps;
        for (std::size_t i = 0; i < transfer.across.fine; i += hn::Lanes(d)) {
            auto sum = hn::Zero(d);
            for (std::size_t n = 0; n < count; ++n) {
                if (down.taken[n][j] == 0) continue;
                const float* const row = fine + (first + n) * transfer.fine_stride;
                sum = hn::MulAdd(hn::Set(d, down.taken[n][j]), hn::LoadU(d, row + i), sum);
            }
            hn::StoreU(sum, d, line + i);
        }
        coarsen_row(transfer.across, line, coarse + j * transfer.coarse_stride);
    }
}

// Adds the values between a row's coarse nodes to its fine ones.
HWY_INLINE void interpolate_row(const NewtonTransferAxis& axis, const float* line,
                                const float* blocks, float* fine) {
    const TransferTag d;
    const hn::RebindToSigned<TransferTag> di;
    const std::size_t lanes = hn::Lanes(d);
    const auto add = [&](std::size_t i, hn::Vec<TransferTag> value) HWY_ATTR {
        const auto free = hn::Gt(hn::LoadU(d, blocks + i), hn::Zero(d));
        hn::StoreU(hn::Add(hn::LoadU(d, fine + i), hn::IfThenElseZero(free, value)), d, fine + i);
    };
    if (axis.halves()) {
        const auto half = hn::Set(d, 0.5f);
        HWY_ALIGN float both[2 * hn::MaxLanes(TransferTag())];
        for (std::size_t c = 0; 2 * c < axis.fine; c += lanes) {
            const auto at = hn::LoadU(d, line + c);
            const auto between = hn::Mul(half, hn::Add(at, hn::LoadU(d, line + c + 1)));
            hn::StoreInterleaved2(at, between, d, both);
            add(2 * c, hn::Load(d, both));
            if (2 * c + lanes < axis.fine) add(2 * c + lanes, hn::Load(d, both + lanes));
        }
        return;
    }
    for (std::size_t i = 0; i < axis.fine; i += lanes) {
        const auto left = hn::LoadU(di, axis.left + i);
        const auto a = hn::GatherIndex(d, line, left), b = hn::GatherIndex(d, line + 1, left);
        add(i, hn::MulAdd(hn::LoadU(d, axis.weight + i), hn::Sub(b, a), a));
    }
}

HWY_NOINLINE void newton_interpolate(const NewtonTransfer& transfer, const NewtonBand& band,
                                     const float* coarse, const float* blocks, float* fine) {
    const TransferTag d;
    float* const line = band.transfer_line(transfer.fine_stride);
    for (std::size_t j = band.row_begin; j < band.row_end; ++j) {
        const auto left = static_cast<std::size_t>(transfer.down.left[j]);
        const float* const above = coarse + left * transfer.coarse_stride;
        const float* const below =
            left + 1 < transfer.down.coarse ? above + transfer.coarse_stride : above;
        const auto weight = hn::Set(d, transfer.down.weight[j]);
        for (std::size_t c = 0; c < transfer.across.coarse; c += hn::Lanes(d)) {
            const auto a = hn::LoadU(d, above + c), b = hn::LoadU(d, below + c);
            hn::StoreU(hn::MulAdd(weight, hn::Sub(b, a), a), d, line + c);
        }
        const std::size_t first = j * transfer.fine_stride;
        interpolate_row(transfer.across, line, blocks + first, fine + first);
    }
}

HWY_NOINLINE double newton_narrow(double scale, const double* from, const float* blocks, float* to,
                                  std::size_t begin, std::size_t end) {
    const hn::ScalableTag<double> d;
    const hn::Rebind<float, decltype(d)> narrow;
    const auto factor = hn::Set(d, scale);
    auto sum = hn::Zero(d);
    for (std::size_t n = begin; n < end; n += hn::Lanes(d)) {
        const auto value = hn::DemoteTo(narrow, hn::Mul(factor, hn::LoadU(d, from + n)));
        const auto free = hn::Gt(hn::LoadU(narrow, blocks + n), hn::Zero(narrow));
        const auto kept = hn::IfThenElseZero(free, value);
        hn::StoreU(kept, narrow, to + n);
        const auto wide = hn::PromoteTo(d, kept);
        sum = hn::MulAdd(wide, wide, sum);
    }
    return hn::GetLane(hn::SumOfLanes(d, sum));
}

// Scalar products are sums in double of sums in float over so many elements.
inline constexpr std::size_t newton_block = 128;

HWY_NOINLINE double newton_advance(float alpha, const float* p, const float* q, float* x, float* r,
                                   std::size_t begin, std::size_t end) {
    const TransferTag d;
    const auto step = hn::Set(d, alpha);
    double total = 0;
    for (std::size_t i = begin; i < end; i += newton_block) {
        auto sum = hn::Zero(d);
        const std::size_t last = i + newton_block < end ? i + newton_block : end;
        for (std::size_t n = i; n < last; n += hn::Lanes(d)) {
            hn::StoreU(hn::MulAdd(step, hn::LoadU(d, p + n), hn::LoadU(d, x + n)), d, x + n);
            const auto left = hn::NegMulAdd(step, hn::LoadU(d, q + n), hn::LoadU(d, r + n));
            hn::StoreU(left, d, r + n);
            sum = hn::MulAdd(left, left, sum);
        }
        total += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, sum)));
    }
    return total;
}

HWY_NOINLINE void newton_turn(float beta, const float* z, float* p, std::size_t begin,
                              std::size_t end) {
    const TransferTag d;
    const auto factor = hn::Set(d, beta);
    for (std::size_t n = begin; n < end; n += hn::Lanes(d)) {
        hn::StoreU(hn::MulAdd(factor, hn::LoadU(d, p + n), hn::LoadU(d, z + n)), d, p + n);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
