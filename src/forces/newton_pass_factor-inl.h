// The diagonal blocks of forces/newton_pass.h, summed and factored with the vectors of one
// instruction set; included once for each.
#if defined(WEFT_FORCES_NEWTON_PASS_FACTOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_FORCES_NEWTON_PASS_FACTOR_INL_H
#undef WEFT_FORCES_NEWTON_PASS_FACTOR_INL_H
#else
#define WEFT_FORCES_NEWTON_PASS_FACTOR_INL_H
#endif

#include <hwy/highway.h>

#include "forces/newton_pass-inl.h"

#if WEFT_SIMD_TARGET
HWY_BEFORE_NAMESPACE();
namespace weft {
namespace HWY_NAMESPACE {

// A symmetric 3 x 3 block a lane: rows {xx, xy, xz} and {yy, yz, zz}.
struct NewtonBlock {
    Pack<NewtonTag> upper, lower;
};

HWY_INLINE NewtonBlock plus(const NewtonBlock& a, const NewtonBlock& b) {
    return {plus(a.upper, b.upper), plus(a.lower, b.lower)};
}

template <int n>
HWY_INLINE NewtonBlock shift_in(const NewtonBlock& current, const NewtonBlock& previous) {
    const NewtonTag d;
    return {shift_in<n>(d, current.upper, previous.upper),
            shift_in<n>(d, current.lower, previous.lower)};
}

// across I + along dx dx^T
HWY_INLINE NewtonBlock newton_spring_block(const NewtonParts& parts, const Pack<NewtonTag>& dx) {
    const Pack<NewtonTag> along = times(parts.along, dx);
    return {
        {hn::MulAdd(along.x, dx.x, parts.across), hn::Mul(along.x, dx.y), hn::Mul(along.x, dx.z)},
        {hn::MulAdd(along.y, dx.y, parts.across), hn::Mul(along.y, dx.z),
         hn::MulAdd(along.z, dx.z, parts.across)}};
}

// One row's sweep, as NewtonRowSweep.
class NewtonFactorSweep {
    using D = NewtonTag;
    using V = hn::Vec<D>;
    using P = Pack<D>;

public:
    HWY_INLINE NewtonFactorSweep(const NewtonGrid& grid, float* lines, std::size_t j, bool writes)
        : grid_(grid),
          writes_(writes),
          first_(j * grid.stride),
          x0_(newton_row(grid, grid.x, j)),
          x1_(newton_row(grid, grid.x, newton_below(grid, j, 1))),
          x2_(newton_row(grid, grid.x, newton_below(grid, j, 2))),
          line0_(lines + 6 * (j % 3) * line_stride()),
          line1_(lines + 6 * ((j + 1) % 3) * line_stride()),
          line2_(lines + 6 * ((j + 2) % 3) * line_stride()),
          row_(grid.row_constants[grid.row_kind(j)]) {}

    HWY_INLINE void sweep() {
        const NewtonCut cut(grid_);
        const std::size_t lanes = hn::Lanes(D());
        vectors<true>(0, cut.left);
        vectors<false>(cut.left * lanes, cut.inner);
        vectors<true>((cut.left + cut.inner) * lanes, cut.right);
    }

private:
    [[nodiscard]] std::size_t line_stride() const { return NewtonBand::line_stride(grid_.stride); }
    [[nodiscard]] HWY_INLINE NewtonBlock load_line(const float* line, std::size_t i) const {
        const D d;
        const auto step = static_cast<std::ptrdiff_t>(line_stride());
        return {load(d, RowOf<const float>{line, step}, i),
                load(d, RowOf<const float>{line + 3 * step, step}, i)};
    }
    HWY_INLINE void store_line(const NewtonBlock& block, float* line, std::size_t i) const {
        const D d;
        const auto step = static_cast<std::ptrdiff_t>(line_stride());
        store(d, block.upper, RowOf<float>{line, step}, i);
        store(d, block.lower, RowOf<float>{line + 3 * step, step}, i);
    }

    template <bool edge>
    HWY_INLINE NewtonBlock block(std::size_t family, std::size_t i, const P& dx) const {
        const auto& families = edge ? row_.edge : row_.inner;
        NewtonParts parts =
            newton_parts(NewtonSpringVectors(families[family], grid_.inverse_tau), dx);
        if constexpr (edge) {
            const V factor = hn::LoadU(D(), grid_.column_factors[family] + i);
            parts = {hn::Mul(factor, parts.across), hn::Mul(factor, parts.along)};
        }
        return newton_spring_block(parts, dx);
    }

    template <bool edge>
    HWY_INLINE void vectors(std::size_t i, std::size_t count) {
        const D d;
        for (const std::size_t end = i + count * hn::Lanes(d); i < end; i += hn::Lanes(d)) {
            const P x = load(d, x0_, i), x_right = load_ahead<1>(d, x, x0_, i);
            const P x_below = load(d, x1_, i);
            NewtonBlock right = block<edge>(along_row, i, minus(x_right, x));
            NewtonBlock down = block<edge>(along_column, i, minus(x_below, x));
            const NewtonBlock diagonal =
                block<edge>(shear, i, minus(load_ahead<1>(d, x_below, x1_, i), x));
            const NewtonBlock far_right =
                block<edge>(bend_row, i, minus(load_ahead<2>(d, x, x0_, i), x));
            const NewtonBlock far_down = block<edge>(bend_column, i, minus(load(d, x2_, i), x));
            NewtonBlock sum = plus(plus(plus(right, down), diagonal), plus(far_right, far_down));
            const NewtonBlock opposite = block<edge>(anti, i, minus(x_below, x_right));
            right = plus(right, opposite);
            down = plus(down, opposite);

            sum = plus(sum, plus(load_line(line0_, i), plus(shift_in<1>(right, carry1_),
                                                            shift_in<2>(far_right, carry2_))));
            store_line(plus(load_line(line1_, i), plus(down, shift_in<1>(diagonal, carry_below_))),
                       line1_, i);
            store_line(far_down, line2_, i);
            carry1_ = right;
            carry2_ = far_right;
            carry_below_ = diagonal;
            if (writes_) factor(sum, i);
        }
    }

    [[nodiscard]] HWY_INLINE V entry(std::size_t n, std::size_t i) const {
        return hn::LoadU(D(), grid_.blocks[n] + first_ + i);
    }

    // B's part, then L diag(d) L^T. No pivot of D is less than B's least eigenvalue, were it not
    // for rounding: taking the least of B's diagonal instead errs on the side of more damping.
    HWY_INLINE void factor(const NewtonBlock& springs, std::size_t i) {
        const D d;
        const V b = entry(0, i);
        V xx = hn::Add(springs.upper.x, b), xy = springs.upper.y, xz = springs.upper.z;
        V yy = springs.lower.x, yz = springs.lower.y, zz = springs.lower.z, least = b;
        if (grid_.isotropic) {
            yy = hn::Add(yy, b);
            zz = hn::Add(zz, b);
        } else {
            xy = hn::Add(xy, entry(1, i));
            xz = hn::Add(xz, entry(2, i));
            yy = hn::Add(yy, entry(3, i));
            yz = hn::Add(yz, entry(4, i));
            zz = hn::Add(zz, entry(5, i));
            least = hn::Min(b, hn::Min(entry(3, i), entry(5, i)));
        }
        const auto free = hn::Gt(b, hn::Zero(d));
        const V one = hn::Set(d, 1.0f);
        const auto inverse = [&](V pivot) HWY_ATTR {
            return hn::IfThenElseZero(free, hn::Div(one, hn::Max(pivot, least)));
        };
        const V i0 = inverse(xx), l10 = hn::Mul(xy, i0), l20 = hn::Mul(xz, i0);
        const V i1 = inverse(hn::NegMulAdd(l10, xy, yy));
        const V t = hn::NegMulAdd(l20, xy, yz), l21 = hn::Mul(t, i1);
        const V i2 = inverse(hn::NegMulAdd(l21, t, hn::NegMulAdd(l20, xz, zz)));
        const V values[6] = {i0, i1, i2, l10, l20, l21};
        for (std::size_t n = 0; n < 6; ++n) hn::StoreU(values[n], d, grid_.factors[n] + first_ + i);
    }

    const NewtonGrid& grid_;
    const bool writes_;
    const std::size_t first_;
    const RowOf<const float> x0_, x1_, x2_;
    float* const line0_;
    float* const line1_;
    float* const line2_;
    const NewtonRow& row_;
    NewtonBlock carry1_{zero_pack(D()), zero_pack(D())}, carry2_ = carry1_, carry_below_ = carry1_;
};

HWY_NOINLINE void newton_factor(const NewtonGrid& grid, const NewtonBand& band) {
    const std::size_t first = band.row_begin > 2 ? band.row_begin - 2 : 0;
    const std::size_t stride = NewtonBand::line_stride(grid.stride);
    for (std::size_t n = 0; n < NewtonBand::sum_lines * stride; ++n) band.lines[n] = 0;
    for (std::size_t j = first; j < band.row_end; ++j) {
        NewtonFactorSweep(grid, band.lines, j, j >= band.row_begin).sweep();
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace weft
HWY_AFTER_NAMESPACE();
#endif  // WEFT_SIMD_TARGET

#endif  // include guard, toggled
